// Long work: how it is cut up for all cores, how it says where it is, and how it is told to stop.
#include <atomic>
#include <numeric>

#include <QTest>

#include "core/base/inplace_vector.h"
#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_work {

using namespace tactum;

class TestWork : public QObject {
    Q_OBJECT

private slots:
    void everyItemIsWorkedOnOnce() {
        for (const std::size_t count : {0, 1, 5, 16383, 16384, 32767, 32768, 100'001}) {
            std::vector<std::atomic<int>> touched(count);
            std::vector<std::atomic<int>> parts(parallelParts(count));
            parallelFor(count, [&](std::size_t part, std::size_t begin, std::size_t end) {
                ++parts[part];
                for (std::size_t i = begin; i < end; ++i)
                    ++touched[i];
            });
            QCOMPARE(std::count(touched.begin(), touched.end(), 1), std::ptrdiff_t(count));
            QCOMPARE(std::count(parts.begin(), parts.end(), 1), std::ptrdiff_t(parts.size()));
        }
    }

    void aThreadHasEnoughToDo() {
        const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
        QCOMPARE(parallelParts(0), 1u);
        QCOMPARE(parallelParts(16384), 1u);
        QCOMPARE(parallelParts(32767), 1u);
        QCOMPARE(parallelParts(32768), std::min<std::size_t>(2, cores));
        QCOMPARE(parallelParts(std::size_t(1) << 40), cores);
    }

    void aPartOfTheWorkIsAPartOfTheWay() {
        std::vector<double> told;
        std::atomic<bool> cancelled{false};
        const Progress whole{[&](double fraction) { told.push_back(fraction); }, &cancelled};
        const Progress part = partOf(whole, 0.2, 0.6);
        for (const double fraction : {0.0, 0.5, 1.0})
            part.report(fraction);
        QCOMPARE(told.size(), 3u);
        COMPARE_NEAR(told[0], 0.2, 1e-12, "");
        COMPARE_NEAR(told[1], 0.4, 1e-12, "");
        COMPARE_NEAR(told[2], 0.6, 1e-12, "");
        QVERIFY(!part.isCancelled());
        cancelled = true;
        QVERIFY(part.isCancelled());
        QVERIFY(whole.isCancelled());
        const Progress silent = partOf({}, 0, 1);
        QVERIFY(!silent.report);
        QVERIFY(!silent.isCancelled());
    }

    void aMeterLooksNowAndThen() {
        std::vector<double> told;
        std::atomic<bool> cancelled{false};
        const Progress progress{[&](double fraction) { told.push_back(fraction); }, &cancelled};
        ProgressMeter meter(progress, 1000, 100);
        for (std::size_t done = 0; done < 350; ++done)
            QVERIFY(meter.goesOn(done));
        QCOMPARE(told, (std::vector<double>{0.1, 0.2, 0.3}));
        cancelled = true;
        QVERIFY(meter.goesOn(399)); // not the turn to look
        QVERIFY(!meter.goesOn(400));
        QCOMPARE(told.back(), 0.4);
        cancelled = false;
        QVERIFY(meter.goesOn(5000)); // more than was thought
        QCOMPARE(told.back(), 1.0);
    }

    void aMeterOfNothingSaysSo() {
        std::vector<double> told;
        const Progress progress{[&](double fraction) { told.push_back(fraction); }, nullptr};
        ProgressMeter meter(progress, 0, 1);
        QVERIFY(meter.goesOn(0));
        QVERIFY(told.empty());
        QVERIFY(meter.goesOn(1));
        QCOMPARE(told, std::vector<double>{1.0});
        ProgressMeter usual(progress, 1 << 20);
        QVERIFY(usual.goesOn((1 << 16) - 1));
        QCOMPARE(told.size(), 1u);
        QVERIFY(usual.goesOn(1 << 16));
        QCOMPARE(told.back(), 1.0 / 16);
        const Progress none;
        ProgressMeter mute(none, 10, 1);
        QVERIFY(mute.goesOn(10));
    }

    void whatIsCancelledSaysSo() {
        const Error error = cancelledError().value();
        QCOMPARE(error.kind, Error::Kind::Input);
        QCOMPARE(error.text, "cancelled");
        QCOMPARE(machineError("x").value().kind, Error::Kind::Machine);
        QCOMPARE(int(Error::Kind::Input), 1); // the exit codes
        QCOMPARE(int(Error::Kind::Usage), 2);
        QCOMPARE(int(Error::Kind::Machine), 3);
    }

    void aBoundedListHoldsAsManyAsItSays() {
        InplaceVector<double, 4> list;
        QCOMPARE(list.size(), 0u);
        for (int i = 0; i < 4; ++i)
            list.push(0.5 * i);
        QCOMPARE(list.size(), 4u);
        QCOMPARE(list.all().size(), 4u);
        list[2] = 9;
        const auto& same = list;
        QCOMPARE(std::accumulate(same.all().begin(), same.all().end(), 0.0), 0 + 0.5 + 9 + 1.5);
        QCOMPARE(same[3], 1.5);
        list.clear();
        QCOMPARE(list.size(), 0u);
        QVERIFY(list.all().empty());
        list.push(7);
        QCOMPARE(list[0], 7.0);
    }
};

TACTUM_TEST(TestWork)

} // namespace test_work

#include "test_work.moc"
