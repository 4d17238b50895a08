// The parts of the servo's guard: readings, velocities, motor heat, the stiffness ceiling.
#include <cmath>
#include <limits>

#include <QTest>

#include "core/port/device_check.h"
#include "core/port/device_mailbox.h"
#include "core/port/reading_clock.h"
#include "core/port/stop_button.h"
#include "core/safety/motor_heat.h"
#include "core/safety/oscillation_detector.h"
#include "core/safety/passivity.h"
#include "core/safety/safe_stiffness.h"
#include "core/safety/sample_check.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_loop_parts {

using namespace tactum;

namespace {

constexpr double kTick = 1e-3;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

DeviceSample at(double z) {
    DeviceSample sample;
    sample.position = {0, 0, z};
    sample.valid = true;
    return sample;
}

} // namespace

class TestLoopParts : public QObject {
    Q_OBJECT

private slots:
    void badReadingsAreNotUsed_data() {
        QTest::addColumn<double>("height");
        QTest::newRow("no number") << kNan;
        QTest::newRow("far away") << 32768 * 55e-6;
    }

    void badReadingsAreNotUsed() {
        QFETCH(double, height);
        SampleCheck check(DeviceInfo{});
        check(at(0.001), kTick);
        QVERIFY(check.believed().jumped); // the first: nobody knows where it came from
        check(at(0.0011), kTick);
        QVERIFY(!check.believed().jumped);
        DeviceSample bad = at(height);
        for (int i = 1; i < kBadSamplesToLoss; ++i) {
            QVERIFY(!check.believes(bad, kTick));
            QVERIFY(check.believes(at(0.0012), kTick));
            QVERIFY(!check(bad, kTick));
            QVERIFY(!check.lost());
            QVERIFY(check.believed().valid);
            QCOMPARE(check.believed().position.z(), 0.0011);
        }
        QVERIFY(!check(bad, kTick));
        QVERIFY(check.lost());
        QVERIFY(!check.believed().valid);
        QCOMPARE(check.refused(), std::uint64_t(kBadSamplesToLoss));
        for (int i = 1; i < kBadSamplesToLoss; ++i) {
            check(at(0.002), kTick);
            QVERIFY(check.lost());
        }
        check(at(0.002), kTick);
        QVERIFY(!check.lost());
        QVERIFY(check.believed().valid);
        QVERIFY(check.believed().jumped);
    }

    /// Late is no lie: the finger stays where it was, and goes on from wherever it may have come to
    /// meanwhile.
    void noReadingsAreNoBadOnes() {
        SampleCheck check(DeviceInfo{});
        check(at(0.001), kTick);
        for (int i = 0; i < 100; ++i) {
            QVERIFY(!check(DeviceSample{}, kTick));
            QVERIFY(!check.lost());
            QVERIFY(check.believed().valid);
            QCOMPARE(check.believed().position.z(), 0.001);
            QCOMPARE_EQ(check.believed().velocity, Vec3(0, 0, 0));
        }
        QCOMPARE(check.refused(), 100u);
        QVERIFY(check(at(0.05), 101 * kTick)); // at 0.5 m/s
        QVERIFY(!check.believed().jumped);
        QCOMPARE(check.believed().position.z(), 0.05);
    }

    /// A slow device that jumps: what is not read between two readings that cannot be true is no excuse for
    /// them.
    void silenceAfterABadReadingCounts() {
        SampleCheck check(DeviceInfo{});
        check(at(0.001), kTick);
        QVERIFY(!check(at(0.02), kTick));
        QVERIFY(!check(DeviceSample{}, kTick));
        QVERIFY(!check.lost());
        QVERIFY(!check(DeviceSample{}, kTick));
        QVERIFY(check.lost());
    }

    void fastestFingerIsBelieved() {
        DeviceInfo info;
        SampleCheck check(info);
        check(at(0), kTick);
        QVERIFY(check.believes(at(1.99 * info.tripSpeed * kTick), kTick));
        QVERIFY(check(at(1.99 * info.tripSpeed * kTick), kTick));
        QVERIFY(!check(at(4.1 * info.tripSpeed * kTick), kTick));
        DeviceSample put = at(1);
        put.jumped = true;
        QVERIFY(check(put, kTick));
    }

    void driversThatTickApart_data() {
        QTest::addColumn<double>("speed"); // m/s, of the finger
        QTest::addColumn<int>("period");   // us, of the driver
        QTest::addColumn<int>("gap");      // us, that its tick 500 comes later
        QTest::newRow("in time") << 1.0 << 1000 << 0;
        QTest::newRow("faster") << 1.0 << 999 << 0;
        QTest::newRow("slower") << 1.0 << 1001 << 0;
        QTest::newRow("half") << 1.0 << 2000 << 0;
        QTest::newRow("late by 2 ms") << 1.0 << 1000 << 2000;
        QTest::newRow("late by 4.5 ms") << 1.0 << 1003 << 4500;
    }

    /// A reading that is taken twice is none; the next one is as far away as it was measured after.
    void driversThatTickApart() {
        QFETCH(double, speed);
        QFETCH(int, period);
        QFETCH(int, gap);
        constexpr std::int64_t kMicrosecond = 1000, kStart = 1'000'000'000, kServo = 1'000'000;
        DeviceMailbox box;
        SampleCheck check(DeviceInfo{});
        ReadingClock readings;
        std::int64_t driver = kStart;
        int drivers = 0, twice = 0;
        for (int i = 1; i <= 3000; ++i) {
            const std::int64_t now = kStart + i * kServo;
            for (; driver <= now; driver += period * kMicrosecond) {
                if (++drivers == 500) driver += gap * kMicrosecond;
                if (driver > now) break;
                box.measured(at(1e-9 * speed * double(driver - kStart)), driver);
            }
            const double apart = readings(box.newest(now), kTick, now);
            QVERIFY(check(box.newest(now), apart));
            twice += apart == 0;
            if (i < 3) continue;
            const double seen = check.believed().velocity.z();
            QVERIFY2(std::abs(seen - speed) < 1e-6, qPrintable(QString("%1: %2").arg(i).arg(seen)));
        }
        if (!(period <= 1000)) QCOMPARE_GT(twice, 0);
    }

    void anExchangeThatTakesLong_data() {
        QTest::addColumn<bool>("readAtItsEnd");
        QTest::newRow("read at its end") << true;
        QTest::newRow("read at its begin") << false;
    }

    /// The next tick begins when it has come back. No finger seems faster than it is.
    void anExchangeThatTakesLong() {
        QFETCH(bool, readAtItsEnd);
        constexpr double kSpeed = 1;
        for (const double takes : {2e-3, 5e-3, 8e-3, 12e-3}) {
            SampleCheck check(DeviceInfo{});
            ReadingClock readings;
            double now = 1, before = now - kTick;
            for (int i = 0; i < 100; ++i) {
                const double begun = now, back = begun + (i == 50 ? takes : 1e-5);
                const double read = readAtItsEnd ? back : begun;
                const double apart = readings(at(kSpeed * read), begun - before, std::int64_t(1e9 * back));
                QVERIFY(check(at(kSpeed * read), apart));
                QCOMPARE_LE(check.believed().velocity.z(), 1.02 * kSpeed);
                before = begun;
                now = std::max(back, begun + kTick);
            }
            QCOMPARE_GT(check.believed().velocity.z(), 0.98 * kSpeed);
        }
    }

    void theStopButtonIsSaid() {
        struct Buttons final : HapticDevice {
            std::uint32_t held = 0;
            double sent = 0;
            DeviceInfo info() const override { return {}; }
            Result<void> open() override { return {}; }
            void close() override {}
            DeviceSample exchange(const DeviceCommand& command, double) noexcept override {
                sent = command.force.norm();
                DeviceSample sample = at(0);
                sample.buttons = held;
                return sample;
            }
        };
        auto made = std::make_unique<Buttons>();
        Buttons& buttons = *made;
        const auto stop = std::make_shared<StopSwitch>();
        stop->buttons = 2;
        StopButton device(std::move(made), stop);
        const DeviceCommand push{{1, 0, 0}};
        buttons.held = 1;
        QVERIFY(!device.exchange(push, kTick).stopped);
        buttons.held = 2;
        QVERIFY(device.exchange(push, kTick).stopped); // this tick's force will not go out
        QCOMPARE(buttons.sent, 1.0);
        buttons.held = 0;
        QVERIFY(device.exchange(push, kTick).stopped); // until somebody says otherwise
        QCOMPARE(buttons.sent, 0.0);
        stop->pressed = false;
        QVERIFY(!device.exchange(push, kTick).stopped);
        QCOMPARE(buttons.sent, 1.0);
    }

    void velocityIsThatOfTheFinger_data() {
        QTest::addColumn<double>("speed");
        for (const double speed : {0.0, 0.001, 0.01, 0.1, 1.0})
            QTest::addRow("%g m/s", speed) << speed;
    }

    /// Within one count over the window, and from one tick to the next at speed.
    void velocityIsThatOfTheFinger() {
        QFETCH(double, speed);
        constexpr double kCount = 50e-6;
        VelocityEstimate estimate(kCount);
        double worst = 0;
        for (int i = 0; i < 400; ++i) {
            const double x = speed * i * kTick + 1.3e-6;
            const double v = estimate(Vec3(kCount * std::round(x / kCount), 0, 0), false, kTick).x();
            if (i > 20) worst = std::max(worst, std::abs(v - speed));
        }
        // A count over sixteen ticks; at speed nothing is worse than the newest difference.
        QCOMPARE_LE(worst, std::max(2 * kCount / (16 * kTick), 0.12 * speed));
    }

    void velocityTurnsAtOnce() {
        VelocityEstimate estimate(50e-6);
        Vec3 v = Vec3::Zero();
        for (int i = 0; i < 20; ++i)
            v = estimate(Vec3(1e-3 * i, 0, 0), false, kTick);
        COMPARE_NEAR(v.x(), 1, 1e-9, "m/s");
        v = estimate(Vec3(18e-3, 0, 0), false, kTick);
        COMPARE_NEAR(v.x(), -1, 1e-9, "m/s");
        v = estimate(Vec3(1, 1, 1), true, kTick);
        QCOMPARE_EQ(v, Vec3(0, 0, 0));
    }

    /// h' = (F^2 / F_c^2 - h) / tau: heat of one after tau ln(r / (r - 1)) for r = (F / F_c)^2.
    void heatFollowsTheClosedForm() {
        constexpr double kTau = 40, kPeak = 3.3, kContinuous = 0.88;
        MotorHeat heat(kPeak, kContinuous);
        QCOMPARE(heat.limit(), kPeak);
        const double ratio = (2.0 / kContinuous) * (2.0 / kContinuous);
        for (int i = 1; i <= 5000; ++i) {
            heat.add(2.0, kTick);
            const double expected = ratio * -std::expm1(-i * kTick / kTau);
            COMPARE_NEAR(heat.heat(), expected, 1e-9 * ratio, "");
        }
        // A press that never ends: the limit settles at what the motors bear, without a step.
        MotorHeat pressed(kPeak, kContinuous);
        double last = kPeak;
        for (int i = 0; i < 600'000; ++i) {
            const double limit = pressed.limit();
            QCOMPARE_LT(last - limit, 0.01); // 10 N/s
            last = limit;
            pressed.add(limit, kTick);
        }
        QCOMPARE_LE(pressed.heat(), 1.01);
        QCOMPARE_GE(last, kContinuous);
        QCOMPARE_LT(last, 1.05 * kContinuous);
    }

    /// However the time without force is cut into pieces.
    void motorsCoolAlsoWhileNobodyCounts() {
        MotorHeat counted(3.3, 0.88), resumed(3.3, 0.88), back(3.3, 0.88);
        counted.resume(0.9, 0);
        QCOMPARE(counted.heat(), 0.9);
        for (int i = 0; i < 20'000; ++i)
            counted.add(0, kTick);
        resumed.resume(0.9, 20'000 * kTick);
        COMPARE_NEAR(resumed.heat(), counted.heat(), 1e-9, "");
        COMPARE_NEAR(resumed.heat(), 0.9 * std::exp(-0.5), 1e-9, "");
        back.resume(0.9, -5); // no clock goes back, and none makes motors hotter
        QCOMPARE(back.heat(), 0.9);
    }

    void ceilingIsThatOfTheRule() {
        // Touch-like in a pinch, 1 kHz, one tick late, 300 Hz: 1.05 * 2.1 / (0.5 + 1 + 0.53 ms).
        LoopFigures loop{.period = 1e-3,
                         .delay = 1e-3,
                         .amplifierLag = 1 / (2 * M_PI * 300),
                         .damping = 2.1,
                         .dryFriction = 0,
                         .resolution = 0,
                         .makersCeiling = 0,
                         .surfaceDamping = 0};
        COMPARE_NEAR(safeStiffness(loop).value, 1085.9, 0.1, "N/m");
        QCOMPARE_EQ(safeStiffness(loop).reason, CeilingReason::Damping);
        loop.dryFriction = 0.05;
        loop.resolution = 200e-6;
        COMPARE_NEAR(safeStiffness(loop).value, 350, 1e-9, "N/m");
        QCOMPARE_EQ(safeStiffness(loop).reason, CeilingReason::Resolution);
        loop.makersCeiling = 100;
        QCOMPARE(safeStiffness(loop).value, 100.0);
        QCOMPARE_EQ(safeStiffness(loop).reason, CeilingReason::Maker);
        // A third of 1.05 * 2.1 N s/m is left for what the surface itself damps with.
        loop.makersCeiling = loop.dryFriction = 0;
        loop.surfaceDamping = 0.47;
        COMPARE_NEAR(safeStiffness(loop).value, 854.5, 0.1, "N/m");
        QCOMPARE_EQ(safeStiffness(loop).reason, CeilingReason::SurfaceDamping);
        COMPARE_NEAR(safeStiffness(loop).damping, 0.735, 1e-9, "N s/m");
        loop.surfaceDamping = 20;
        COMPARE_NEAR(safeStiffness(loop).value, 1085.9 * 2 / 3, 0.1, "N/m");
        const StiffnessCeiling typical = safeStiffness(loopFigures(DeviceInfo{}));
        COMPARE_NEAR(typical.value, 1.05 * 2 / 1.5e-3, 1e-9, "N/m");
    }

    /// 0 / 0, and figures that no driver can mean.
    void withoutFiguresNothingIsStiff() {
        for (const LoopFigures& loop :
             {LoopFigures{.period = 0}, LoopFigures{.period = 0, .damping = 2}, LoopFigures{.damping = -1},
              LoopFigures{.period = kNan, .damping = 2}, LoopFigures{.damping = kNan}}) {
            QCOMPARE(safeStiffness(loop).value, 0.0);
            QCOMPARE(safeStiffness(loop).damping, 0.0);
        }
    }

    void figuresThatCannotBeAreRefused_data() {
        QTest::addColumn<double>("rate");
        QTest::addColumn<double>("speed");
        QTest::newRow("no rate") << 0.0 << 1.5;
        QTest::newRow("backwards") << -1000.0 << 1.5;
        QTest::newRow("no number") << kNan << 1.5;
        QTest::newRow("each tick a stall") << 50.0 << 1.5;
        QTest::newRow("absurd") << 1e9 << 1.5;
        QTest::newRow("never moves") << 1000.0 << 0.0;
    }

    void figuresThatCannotBeAreRefused() {
        QFETCH(double, rate);
        QFETCH(double, speed);
        VERIFY_RESULT(checkDevice({}));
        const auto refused = checkDevice({.name = "Odd\none", .rate = rate, .tripSpeed = speed});
        QVERIFY(!refused.has_value());
        COMPARE_CONTAINS(refused.error().text, "Odd");
        COMPARE_CONTAINS(refused.error().text, rate == 1000 ? "trip speed" : "rate");
        COMPARE_LACKS(refused.error().text, "\n");
    }

    /// It would stay in the sum for ever.
    void energyForgetsWhatIsNoNumber() {
        Passivity passivity(DeviceInfo{});
        passivity.observe(Vec3::Zero(), Vec3::Zero(), kTick);
        passivity.observe(Vec3::Constant(kNan), Vec3::Zero(), kTick);
        passivity.observe(Vec3::Zero(), Vec3::Constant(kNan), kTick);
        RenderedSpring spring{.force = Vec3::UnitZ(), .stiffness = 100, .stretch = 0.01, .limit = 8};
        spring.velocity = Vec3::Constant(kNan);
        for (int i = 0; i < 3; ++i)
            passivity.commanded(spring);
        passivity.observe(Vec3::Zero(), Vec3::Zero(), kTick);
        QVERIFY(std::isfinite(passivity.energy()));
        QVERIFY(std::isfinite(passivity.damping({}, Vec3::UnitZ(), kTick)));
    }

    /// A sampled spring makes K / 2 (v T)^2 in each tick, in and out; of which the device's damping takes a
    /// part. At this speed a tick's work is more than the balance may remember, either way.
    void energyOfAFastFingerIsNeitherMadeUpNorHidden() {
        constexpr double kStiff = 3000, kStep = 5e-4, kCredit = 0.75;
        constexpr int kDeep = 10; // steps
        constexpr double kMade = 0.5 * kStiff * kStep * kStep;
        for (const double part : {1.0, 0.75}) {
            DeviceInfo info;
            info.delay = 0;
            info.damping = part * 0.5 * kStiff * kTick / kCredit;
            Passivity passivity(info);
            double most = 0;
            for (int i = 0; i <= 2 * kDeep; ++i) {
                const double depth = kStep * std::min(i, 2 * kDeep - i);
                const double speed = i == 0 ? 0 : kStep / kTick * (i <= kDeep ? -1 : 1);
                passivity.observe({0, 0, -depth}, {0, 0, speed}, kTick);
                passivity.commanded({.force = kStiff * depth * Vec3::UnitZ(),
                                     .stiffness = kStiff,
                                     .stretch = depth,
                                     .limit = 100});
                most = std::max(most, passivity.energy());
            }
            constexpr double kForgotten = 2e-4 * 2 * kDeep * kTick;
            const double expected = (1 - part) * kMade * 2 * kDeep;
            QVERIFY2(std::abs(passivity.energy() - expected) <= kForgotten,
                     qPrintable(QString("%1 J, not %2").arg(passivity.energy()).arg(expected)));
            QVERIFY2(most <= expected + kForgotten, qPrintable(QString("up to %1 J").arg(most)));
        }
    }

    void whatIsNoLimitCycle_data() {
        QTest::addColumn<double>("least"); // Hz
        QTest::addColumn<double>("most");
        QTest::addColumn<double>("narrowest"); // m, from end to end
        QTest::addColumn<double>("widest");
        QTest::newRow("a hand, and its tremor") << 1.0 << 15.0 << 5e-5 << 2e-2;
        QTest::newRow("a fine texture") << 20.0 << 300.0 << 1e-6 << 1e-4;
        QTest::newRow("two counts of a coarse device") << 20.0 << 40.0 << 1e-4 << 1.2e-4;
        QTest::newRow("faster than any loop") << 700.0 << 1900.0 << 2e-4 << 2e-3;
    }

    /// Whatever the swing begins with, and however long it lasts.
    void whatIsNoLimitCycle() {
        QFETCH(double, least);
        QFETCH(double, most);
        QFETCH(double, narrowest);
        QFETCH(double, widest);
        constexpr int kSteps = 28, kPhases = 16;
        int alarms = 0;
        double lowest = 1e9, highest = 0; // Hz, of those that gave one
        for (int i = 0; i <= kSteps; ++i)
            for (const double part : {0.0, 0.5, 1.0})
                for (int phase = 0; phase < kPhases; ++phase) {
                    const double frequency = least + (most - least) * i / kSteps;
                    const double half = 0.5 * narrowest * std::pow(widest / narrowest, part);
                    const double tick = most > 500 ? 0.25 * kTick : kTick;
                    OscillationDetector detector;
                    bool alarm = false;
                    for (double t = 0; t < 1; t += tick)
                        alarm |= detector(
                            Vec3(0, half * std::sin(2 * M_PI * (frequency * t + double(phase) / kPhases)), 0),
                            tick);
                    if (!alarm) continue;
                    ++alarms;
                    lowest = std::min(lowest, frequency);
                    highest = std::max(highest, frequency);
                }
        QVERIFY2(
            alarms == 0,
            qPrintable(
                QString("%1 alarms instead of 0, from %2 to %3 Hz").arg(alarms).arg(lowest).arg(highest)));
    }

    /// What a tap sets ringing has died away within a sixteenth of a second; what lasts longer is told of,
    /// and when it does not end, again after as long.
    void aLimitCycleIsToldOnceInASixteenthOfASecond() {
        constexpr double kSixteenth = 1.0 / 16;
        const auto shaken = [](int i) { return Vec3(0, 0, 1e-3 * std::sin(2 * M_PI * 50 * i * kTick)); };
        for (const int swings : {1, 2, 3, 5}) {
            OscillationDetector detector;
            int alarms = 0;
            for (int burst = 0; burst < 20; ++burst)
                for (int i = 0; i < 20 * swings + 200; ++i)
                    alarms += detector(i < 20 * swings ? shaken(i) : Vec3::Zero(), kTick);
            QVERIFY2(alarms == (swings < 4 ? 0 : 20),
                     qPrintable(QString("%1 alarms of 20 times %2 swings").arg(alarms).arg(swings)));
        }
        OscillationDetector detector;
        double last = -kSixteenth;
        int alarms = 0;
        for (int i = 0; i < 1000; ++i) {
            if (!detector(shaken(i), kTick)) continue;
            QCOMPARE_GE(i * kTick - last, kSixteenth);
            last = i * kTick;
            ++alarms;
        }
        QCOMPARE_GE(alarms, 10);
    }

    /// Wide and narrow in turn, as over a coarse texture.
    void unevenSwingsAreNoLimitCycle() {
        for (const double ratio : {2.5, 3.0, 4.0}) {
            OscillationDetector detector;
            int alarms = 0;
            double place = 0;
            for (int i = 0; i < 2000; ++i) {
                const bool up = i / 10 % 2 == 0, isWide = i / 20 % 2 == 0;
                place += (up ? 1 : -1) * (isWide ? 1e-3 : 1e-3 / ratio) / 10;
                alarms += detector(Vec3(place, 0, 0), kTick);
            }
            QVERIFY2(
                alarms == 0,
                qPrintable(
                    QString("%1 alarms instead of 0, one swing %2 times the next").arg(alarms).arg(ratio)));
        }
    }

    /// Each swing narrower than the one before, or much wider.
    void whatDiesAwayOrIsThrownIsNoLimitCycle() {
        // By 0.7 a tap of 0.33 m/s rings on the stiffest surface that a grasp bears.
        for (const double ratio : {1 / 2.5, 0.7, 2.5})
            for (const int half : {10, 15, 20}) { // ticks
                OscillationDetector detector;
                int alarms = 0;
                double place = 0, swing = ratio < 0.5 ? 0.03 : ratio < 1 ? 0.01 : 2e-4;
                for (int i = 0; i < 6 * half; ++i) {
                    place += (i / half % 2 ? -1 : 1) * swing / half;
                    if (i % half == half - 1) swing *= ratio;
                    alarms += detector(Vec3(place, 0, 0), kTick);
                }
                QVERIFY2(alarms == 0,
                         qPrintable(QString("%1 alarms instead of 0, each swing %2 times the last, "
                                            "%3 ms long")
                                        .arg(alarms)
                                        .arg(ratio)
                                        .arg(half)));
            }
    }

    void swingsAreSeenAfterWhatIsNoNumber() {
        OscillationDetector detector;
        QVERIFY(!detector(Vec3::Constant(kNan), kTick));
        bool seen = false;
        for (int i = 0; i < 200; ++i)
            seen |= detector(Vec3(0, 0, 1e-3 * std::sin(2 * M_PI * 50 * i * kTick)), kTick);
        QVERIFY(seen);
    }
};

TACTUM_TEST(TestLoopParts)

} // namespace test_loop_parts

#include "test_loop_parts.moc"
