// The clock of the loops. Only lower bounds are checked: how late a machine wakes a thread is its own affair.
#include <cmath>

#include <QtTest>

#include "core/runtime/metronome.h"

using namespace tactum;

namespace {

void workFor(double seconds) {
    const std::int64_t end = monotonicNanoseconds() + std::int64_t(1e9 * seconds);
    while (monotonicNanoseconds() < end) {
    }
}

} // namespace

class TestMetronome : public QObject {
    Q_OBJECT

private slots:
    void neverRunsAheadOfItsRate() {
        Metronome metronome(2000);
        Tick tick;
        for (int i = 1; i <= 400; ++i) {
            tick = metronome.wait();
            QVERIFY(tick.time >= i / 2000.0);
        }
    }

    void elapsedTimesAddUpToTheTime() {
        Metronome metronome(2000);
        const Tick first = metronome.wait();
        QCOMPARE(first.elapsed, metronome.period());
        double sum = first.time;
        Tick tick;
        for (int i = 0; i < 400; ++i) {
            tick = metronome.wait();
            sum += tick.elapsed;
        }
        QVERIFY(std::abs(sum - tick.time) < 1e-9);
    }

    void missedTicksAreNotCaughtUpInABurst() {
        Metronome metronome(1000);
        metronome.wait();
        workFor(0.02);
        const Tick late = metronome.wait();
        QVERIFY(late.missed);
        Tick after;
        for (int i = 1; i <= 10; ++i)
            after = metronome.wait();
        QVERIFY(after.time - late.time >= 0.01 - 1e-9);
    }

    void overloadedLoopStillRests() {
        constexpr double kRest = 0.125, kWork = 0.002;
        Metronome metronome(2000, kRest);
        metronome.wait();
        for (int i = 0; i < 20; ++i) {
            workFor(kWork);
            QVERIFY(metronome.wait().elapsed >= kWork * (1 + kRest) - 1e-9);
        }
    }

    void halfSecondSpeaksOfTheLastFullOne() {
        HalfSecond statistics;
        for (int i = 0; i < 100; ++i)
            statistics.add(0.004 * i, 1000);
        QCOMPARE(statistics.rate(), 0.0); // not over yet
        statistics.add(0.5, 1000);
        QCOMPARE(statistics.rate(), 202.0);
        for (int i = 1; i <= 250; ++i)
            statistics.add(0.5 + 0.002 * i, i % 2 ? 1 : 3);
        QVERIFY(std::abs(statistics.rate() - 500) < 1e-6);
        QVERIFY(std::abs(statistics.mean() - 2) < 1e-9);
        QCOMPARE(statistics.worst(), 3.0);
    }
};

QTEST_APPLESS_MAIN(TestMetronome)
#include "test_metronome.moc"
