// The clock of the loops. Only lower bounds are checked: how late a machine wakes a thread is its own affair.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include <QTest>

#include "core/loop/metronome.h"
#include "core/runtime/period_histogram.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_metronome {

using namespace tactum;

namespace {

void workFor(double seconds) {
    const std::int64_t end = monotonicNanoseconds() + std::int64_t(1e9 * seconds);
    while (monotonicNanoseconds() < end) {
    }
}

/// Has a frame so many ns after it was asked for one: one that kept a beat of its own would owe the time by
/// which the machine woke the tick before too late.
class FramedDevice final : public HapticDevice {
public:
    explicit FramedDevice(std::int64_t every, bool tells = true) : every_(every), tells_(tells) {}
    DeviceInfo info() const override { return {}; }
    Result<void> open() override { return {}; }
    void close() override {}
    DeviceSample exchange(const DeviceCommand&, double) noexcept override { return {}; }
    bool awaitFrame(std::int64_t until) noexcept override {
        const std::int64_t frame = std::min(until, monotonicNanoseconds() + every_);
        while (tells_ && monotonicNanoseconds() < frame) {
        }
        return tells_;
    }

private:
    std::int64_t every_;
    bool tells_;
};

std::atomic<std::int64_t> slept{0}; // ns, of a machine that the test sends to sleep

std::int64_t sleepersClock() noexcept {
    return monotonicNanoseconds() + slept;
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
            QCOMPARE_GE(tick.time, i / 2000.0);
        }
    }

    /// Slower than its rate, no faster than four times, and half a period late where none comes.
    void framesAreTheTicks() {
        for (const auto& [every, least] :
             {std::pair{1.2e-3, 1.2e-3}, std::pair{0.0, 0.25e-3}, std::pair{1.0, 1.5e-3}}) {
            FramedDevice device{std::int64_t(1e9 * every)};
            Metronome metronome(1000);
            metronome.wait(device);
            Tick tick;
            double sum = 0;
            for (int i = 1; i <= 50; ++i) {
                tick = metronome.wait(device);
                sum += tick.elapsed;
                QCOMPARE_GE(tick.late, 0);
            }
            QCOMPARE_GE(sum, 50 * least * 0.999);
        }
    }

    void whoHasNoFramesKeepsTheClock() {
        FramedDevice device{0, false};
        Metronome metronome(2000);
        for (int i = 1; i <= 100; ++i)
            QCOMPARE_GE(metronome.wait(device).time, i / 2000.0);
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
        COMPARE_NEAR(sum, tick.time, 1e-9, "s");
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
        QCOMPARE_GE(after.time - late.time, 0.01 - 1e-9);
    }

    /// What the loop did before made it late, or the machine did: it says whether it slept.
    void whoCameLateDidNotSleep() {
        Metronome metronome(1000);
        metronome.wait();
        for (int i = 0; i < 5; ++i) {
            workFor(0.003);
            QVERIFY(!metronome.wait().asleep);
        }
        Metronome slow(50); // 20 ms are enough to come in time now and then
        bool slept = false;
        for (int i = 0; i < 200 && !slept; ++i)
            slept = slow.wait().asleep;
        QVERIFY(slept);
    }

    void overloadedLoopStillRests() {
        constexpr double kRest = 0.125, kWork = 0.002;
        Metronome metronome(2000, kRest);
        metronome.wait();
        for (int i = 0; i < 20; ++i) {
            workFor(kWork);
            QCOMPARE_GE(metronome.wait().elapsed, kWork * (1 + kRest) - 1e-9);
        }
    }

    /// CLOCK_MONOTONIC does not know that it was asleep.
    void aSleepingMachineCounts() {
        constexpr double kHour = 3600;
        Metronome metronome(1000, 0, sleepersClock);
        for (int i = 0; i < 20; ++i)
            QCOMPARE_LT(metronome.wait().elapsed, kHour);
        slept += std::int64_t(kHour) * 1'000'000'000;
        const Tick after = metronome.wait();
        QCOMPARE_GT(after.elapsed, 0.99 * kHour);
        QVERIFY(after.missed);
        QCOMPARE_LT(after.time, kHour);
        double sum = after.elapsed; // the same hour does not count twice
        for (int i = 0; i < 20; ++i)
            sum += metronome.wait().elapsed;
        QCOMPARE_GE(sum, kHour);
        QCOMPARE_LT(sum, 1.5 * kHour);
    }

    /// A loop that becomes worse after hours, and well again.
    void periodsAreThoseOfTheLastSeconds() {
        RecentPeriods periods;
        double now = 0;
        const auto tick = [&](double seconds, double micros) {
            for (const double end = now + seconds; now < end; now += 1e-3)
                periods.add(now, micros);
        };
        tick(3600, 3);
        QCOMPARE(periods.counted().quantile(0.999), 5.0);
        tick(0.1, -990); // too short is no gap
        QCOMPARE(periods.counted().longest, 3.0);
        tick(0.1, 1500);
        QCOMPARE(periods.counted().quantile(0.999), 2000.0);
        QCOMPARE(periods.counted().longest, 1500.0);
        tick(RecentPeriods::kPeriodWindow, 3); // it is among the older ones now
        QCOMPARE(periods.counted().longest, 1500.0);
        tick(2 * RecentPeriods::kPeriodWindow, 3);
        QCOMPARE(periods.counted().quantile(0.999), 5.0);
        QCOMPARE(periods.counted().longest, 3.0);
        std::uint64_t ticks = 0;
        for (const std::uint32_t count : periods.counted().count)
            ticks += count;
        QCOMPARE_GT(ticks, 4900);
        QCOMPARE_LT(ticks, 10100);
        now += 3600; // the machine slept
        periods.add(now, 9000);
        QCOMPARE(periods.counted().quantile(0.001), 10000.0);
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
        COMPARE_NEAR(statistics.rate(), 500, 1e-6, "Hz");
        COMPARE_NEAR(statistics.mean(), 2, 1e-9, "");
        QCOMPARE(statistics.worst(), 3.0);
    }

    void whatCouldNotHappenIsNotCounted() {
        HalfSecond statistics;
        for (double now = 0; now < 60; now += 0.01)
            statistics.begin(now);
        for (int i = 1; i <= 300; ++i) {
            statistics.add(60 + 0.002 * i, 1);
            if (i < 200) QCOMPARE(statistics.rate(), 0.0); // no half second yet
        }
        COMPARE_NEAR(statistics.rate(), 500, 20, "Hz");
    }
};

TACTUM_TEST(TestMetronome)

} // namespace test_metronome

#include "test_metronome.moc"
