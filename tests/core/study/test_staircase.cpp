// Staircases: the rule step by step, and where they settle for observers whose psychometric function is
// known.
#include <QTest>

#include <cmath>

#include "core/study/study_run.h"
#include "tests/core/study/simple_designs.h"
#include "tests/support/compare.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"

namespace test_staircase {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kMiddle = 20; // where the observer is right half of the time; its spread is 1

double rightAt(double level) {
    return 1 / (1 + std::exp(kMiddle - level));
}

struct Settled {
    double mean = 0;
    double spread = 0; ///< standard deviation of a run
};

/// Of `runs` runs of a yes-no staircase through StudyRun, as the window leads it.
Settled settled(int down, int runs) {
    StudyDesign design = staircaseOf(down);
    design.staircase.compares = false;
    Rng random(down);
    double sum = 0, squares = 0;
    for (int i = 0; i < runs; ++i) {
        auto run = StudyRun::begin(design, i + 1, 1);
        run->proceed();
        while (run->step() != StudyStep::Done) {
            run->proceed();
            const bool right = uniform(random, 0, 1) < rightAt(run->trial().level);
            if (!run->choose(right ? 0 : 1)) return {};
        }
        const double threshold = run->threshold()->mean;
        sum += threshold;
        squares += threshold * threshold;
    }
    const double mean = sum / runs;
    return {mean, std::sqrt(squares / runs - mean * mean)};
}

std::vector<double> levelsOf(const StaircaseRule& rule, const std::vector<bool>& answers) {
    Staircase staircase(rule);
    std::vector<double> levels{staircase.level()};
    for (const bool correct : answers) {
        staircase.answer(correct);
        levels.push_back(staircase.level());
    }
    return levels;
}

} // namespace

class TestStaircase : public QObject {
    Q_OBJECT

private slots:
    void theRuleStepByStep();
    void stepsThatMultiply();
    void levelsStayInTheirRange();
    void theThresholdIsAMeanOfReversals();
    void itEnds();
    void settlesWhereLevittSays_data();
    void settlesWhereLevittSays();
    void theStrongerIntervalIsEitherOne();
};

void TestStaircase::theRuleStepByStep() {
    StaircaseRule rule;
    rule.start = 100;
    rule.steps = {40, 10};
    rule.down = 2;
    // Two right: down. Two right: down. Wrong: up, the first reversal, by the second step. Two right: down.
    const std::vector<double> expected{100, 100, 60, 60, 20, 30, 30, 20};
    QCOMPARE(levelsOf(rule, {true, true, true, true, false, true, true}), expected);
    // One right answer between wrong ones counts for nothing.
    QCOMPARE(levelsOf(rule, {true, false, true, false}), (std::vector<double>{100, 100, 140, 140, 180}));
}

void TestStaircase::stepsThatMultiply() {
    StaircaseRule rule;
    rule.start = 64;
    rule.smallest = 1;
    rule.steps = {2};
    rule.ratio = true;
    rule.down = 1;
    QCOMPARE(levelsOf(rule, {true, true, false}), (std::vector<double>{64, 32, 16, 32}));
}

void TestStaircase::levelsStayInTheirRange() {
    StaircaseRule rule;
    rule.start = rule.largest = 50;
    rule.steps = {30};
    rule.down = 1;
    QCOMPARE(levelsOf(rule, {false, true, true, true}), (std::vector<double>{50, 50, 20, 0, 0}));
}

void TestStaircase::theThresholdIsAMeanOfReversals() {
    StaircaseRule rule;
    rule.start = 100;
    rule.steps = {10};
    rule.down = 1;
    rule.used = 3;
    Staircase staircase(rule);
    QVERIFY(!staircase.threshold());
    for (const bool correct : {true, false, true, true, false, true})
        staircase.answer(correct);
    // 100 down to 90, wrong: up from 90 (reversal) to 100, right: down from 100 (reversal) to 90, 80, wrong:
    // 80 (reversal), right: 90 (reversal).
    QCOMPARE(staircase.reversals(), (std::vector<double>{90, 100, 80, 90}));
    QCOMPARE(staircase.threshold()->reversals, 3);
    COMPARE_NEAR(staircase.threshold()->mean, 90, 1e-12, "");
    COMPARE_NEAR(staircase.threshold()->error, 10 / std::sqrt(3.), 1e-12, "");
}

void TestStaircase::itEnds() {
    StaircaseRule rule;
    rule.down = 1;
    rule.reversals = 4;
    rule.trials = 6;
    Staircase turning(rule), straight(rule);
    int trials = 0;
    for (; !turning.done(); ++trials)
        turning.answer(trials % 2 == 0);
    QCOMPARE(trials, 5); // the first answer turns nothing
    for (trials = 0; !straight.done(); ++trials)
        straight.answer(false);
    QCOMPARE(trials, 6);
}

void TestStaircase::settlesWhereLevittSays_data() {
    QTest::addColumn<int>("down");
    QTest::addColumn<double>("proportion"); // table I of Levitt 1971
    QTest::newRow("1 down 1 up") << 1 << 0.5;
    QTest::newRow("2 down 1 up") << 2 << 0.707;
    QTest::newRow("3 down 1 up") << 3 << 0.794;
    QTest::newRow("4 down 1 up") << 4 << 0.841;
}

/// Within the standard deviation of a run by far; what is left, under 0.1 of the observer's spread, is the
/// size of the step.
void TestStaircase::settlesWhereLevittSays() {
    QFETCH(int, down);
    QFETCH(double, proportion);
    const Settled all = settled(down, 500);
    const double target = kMiddle + std::log(proportion / (1 - proportion));
    COMPARE_NEAR(all.mean, target, 0.1, "");
    QCOMPARE_LT(std::abs(all.mean - target), all.spread);
    COMPARE_NEAR(rightAt(all.mean), proportion, 0.02, "");
}

void TestStaircase::theStrongerIntervalIsEitherOne() {
    auto run = StudyRun::begin(staircaseOf(1), 1, 1);
    VERIFY_RESULT(run);
    run->proceed();
    int second = 0, trials = 0;
    for (; run->step() != StudyStep::Done && trials < 400; ++trials) {
        const auto& intervals = run->trial().intervals;
        const auto right = std::size_t(*run->trial().right);
        QCOMPARE(*intervals[right].value, 400 + run->trial().level);
        QCOMPARE(*intervals[1 - right].value, 400.0);
        second += int(right);
        run->proceed();
        run->proceed();
        VERIFY_RESULT(run->choose(trials % 8 == 7 ? 1 - int(right) : int(right)));
    }
    // Half, within four standard deviations.
    COMPARE_NEAR(second, 0.5 * trials, 2 * std::sqrt(double(trials)), "");
}

} // namespace test_staircase

using test_staircase::TestStaircase;
TACTUM_TEST(TestStaircase)
#include "test_staircase.moc"
