// Orders of trials: balanced squares, uniform permutations, A, B and X each as often.
#include <QTest>

#include <map>
#include <set>

#include "core/study/trial_order.h"
#include "tests/core/study/simple_designs.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_trial_order {

using namespace tactum;
using namespace tactum::test;

namespace {

std::vector<int> conditionsOf(const std::vector<StudyTrial>& trials) {
    std::vector<int> all;
    for (const StudyTrial& trial : trials)
        all.push_back(trial.intervals[0].condition);
    return all;
}

/// Once in each place, or twice, and after each other one equally often.
struct Balance {
    std::set<int> inPlaces, after;
};
Balance balanceOf(int count, int rows) {
    std::map<std::pair<int, int>, int> places, pairs;
    for (int row = 0; row < rows; ++row) {
        const std::vector<int> order = latinRow(count, row);
        for (int place = 0; place < count; ++place) {
            ++places[{place, order[std::size_t(place)]}];
            if (place > 0) ++pairs[{order[std::size_t(place - 1)], order[std::size_t(place)]}];
        }
    }
    Balance balance;
    for (int a = 0; a < count; ++a)
        for (int b = 0; b < count; ++b) {
            balance.inPlaces.insert(places[{a, b}]);
            if (a != b) balance.after.insert(pairs[{a, b}]);
        }
    return balance;
}

} // namespace

class TestTrialOrder : public QObject {
    Q_OBJECT

private slots:
    void squaresAreBalanced();
    void participantsHaveTheirRows();
    void randomOrdersAreUniform();
    void theSameSeedIsTheSameOrder();
    void eachRepetitionHasAll();
    void xIsEachOfTheTwo();
    void pairsComeBothWaysRound();
};

void TestTrialOrder::squaresAreBalanced() {
    for (const int count : {2, 4, 6, 10}) {
        const Balance balance = balanceOf(count, count);
        QVERIFY2(balance.inPlaces == std::set{1}, qPrintable(QString::number(count)));
        QVERIFY2(balance.after == std::set{1}, qPrintable(QString::number(count)));
    }
    for (const int count : {3, 5, 7}) {
        const Balance balance = balanceOf(count, 2 * count);
        QVERIFY2(balance.inPlaces == std::set{2}, qPrintable(QString::number(count)));
        QVERIFY2(balance.after == std::set{2}, qPrintable(QString::number(count)));
    }
    QCOMPARE(latinRow(1, 5), std::vector{0});
}

void TestTrialOrder::participantsHaveTheirRows() {
    StudyDesign design = designOf(Procedure::List, {"a", "b", "c", "d"}, 2);
    design.order = StudyOrder::Balanced;
    for (int participant = 1; participant <= 8; ++participant) {
        std::vector<int> expected = latinRow(4, participant - 1);
        for (const int condition : latinRow(4, participant))
            expected.push_back(condition);
        QCOMPARE(conditionsOf(trialsFor(design, participant, 1)), expected);
    }
}

/// Chi-square over the 24 orders of four: 23 degrees of freedom, 49.73 is passed once in a thousand.
void TestTrialOrder::randomOrdersAreUniform() {
    constexpr int kRuns = 24000;
    const StudyDesign design = designOf(Procedure::List, {"a", "b", "c", "d"});
    std::map<std::vector<int>, int> counts;
    for (int participant = 1; participant <= kRuns; ++participant)
        ++counts[conditionsOf(trialsFor(design, participant, 7))];
    QCOMPARE(counts.size(), std::size_t(24));
    double chiSquare = 0;
    for (const auto& [order, count] : counts)
        chiSquare += (count - kRuns / 24.) * (count - kRuns / 24.) / (kRuns / 24.);
    QCOMPARE_LT(chiSquare, 49.73);
    QCOMPARE_GT(chiSquare, 7.53); // nor evener than chance is, as often
}

void TestTrialOrder::theSameSeedIsTheSameOrder() {
    const StudyDesign design = designOf(Procedure::List, {"a", "b", "c", "d", "e", "f"});
    QCOMPARE(conditionsOf(trialsFor(design, 3, 11)), conditionsOf(trialsFor(design, 3, 11)));
    QVERIFY(conditionsOf(trialsFor(design, 3, 11)) != conditionsOf(trialsFor(design, 4, 11)));
    QVERIFY(conditionsOf(trialsFor(design, 3, 11)) != conditionsOf(trialsFor(design, 3, 12)));
    // A log of today has to mean the same with another compiler.
    QCOMPARE(conditionsOf(trialsFor(design, 1, 1)), (std::vector{4, 5, 0, 3, 2, 1}));
}

void TestTrialOrder::eachRepetitionHasAll() {
    const StudyDesign design = designOf(Procedure::List, {"a", "b", "c"}, 20);
    const std::vector<int> order = conditionsOf(trialsFor(design, 1, 5));
    QCOMPARE(order.size(), std::size_t(60));
    for (auto block = order.begin(); block != order.end(); block += 3)
        QCOMPARE(std::set(block, block + 3).size(), std::size_t(3));
}

void TestTrialOrder::xIsEachOfTheTwo() {
    const auto trials = trialsFor(designOf(Procedure::Abx, {"soft", "stiff"}, 8), 1, 3);
    std::map<std::pair<int, int>, int> ways; // what A is, and which of the two X is
    for (const StudyTrial& trial : trials) {
        QCOMPARE(trial.intervals.size(), std::size_t(3));
        QVERIFY(trial.intervals[0] != trial.intervals[1]);
        QVERIFY(trial.right.has_value());
        QCOMPARE(trial.intervals[2].condition, trial.intervals[std::size_t(*trial.right)].condition);
        ++ways[{trial.intervals[0].condition, *trial.right}];
    }
    QCOMPARE(ways.size(), std::size_t(4));
    for (const auto& [way, count] : ways)
        QCOMPARE(count, 2);
}

void TestTrialOrder::pairsComeBothWaysRound() {
    StudyDesign design = designOf(Procedure::Pairs, {"a", "b", "c"}, 2);
    std::map<std::pair<int, int>, int> ways;
    for (const StudyTrial& trial : trialsFor(design, 1, 3)) {
        ++ways[{trial.intervals[0].condition, trial.intervals[1].condition}];
        QVERIFY(!trial.right);
    }
    QCOMPARE(ways.size(), std::size_t(6));
    design.order = StudyOrder::AsListed;
    for (const StudyTrial& trial : trialsFor(design, 1, 3))
        QCOMPARE_LT(trial.intervals[0].condition, trial.intervals[1].condition);
}

} // namespace test_trial_order

using test_trial_order::TestTrialOrder;
TACTUM_TEST(TestTrialOrder)
#include "test_trial_order.moc"
