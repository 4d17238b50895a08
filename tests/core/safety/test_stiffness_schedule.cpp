// The stiffness schedule: what lowers the ceiling, how fast, and how it comes back.
#include <cmath>

#include <QTest>

#include "core/safety/command_check.h"
#include "core/safety/stiffness_schedule.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_stiffness_schedule {

using namespace tactum;

namespace {

constexpr double kTick = 1e-3; // s

double ceilingAt(double period) {
    LoopFigures loop = loopFigures(DeviceInfo{});
    loop.period = period;
    return safeStiffness(loop).value;
}

} // namespace

class TestStiffnessSchedule : public QObject {
    Q_OBJECT

private slots:
    /// Five late ticks may happen; with the sixth in a row the loop is taken for what it is, and believed
    /// again in seconds.
    void aLoopThatIsLateIsSofterAndComesBack() {
        StiffnessSchedule schedule(DeviceInfo{});
        DeviceSample seen;
        const auto tick = [&](double dt, bool late) {
            return schedule({.seen = seen, .dt = dt, .late = late, .stiffness = 1e6}).stiffness;
        };
        COMPARE_NEAR(tick(kTick, false), ceilingAt(kTick), 1e-9, "N/m");
        for (int burst = 0; burst < 3; ++burst) {
            for (int i = 0; i < 5; ++i)
                COMPARE_NEAR(tick(3e-3, true), ceilingAt(kTick), 1e-9, "N/m");
            tick(kTick, false);
        }
        for (int i = 0; i < 6; ++i)
            tick(3e-3, true);
        COMPARE_NEAR(schedule.ceiling().value, ceilingAt(3e-3), 1e-6, "N/m");
        for (int i = 0; i < 2000; ++i)
            tick(kTick, false);
        COMPARE_NEAR(schedule.period(), 1.5e-3, 1e-5, "s"); // half of it in 2 s
        for (int i = 0; i < 2000; ++i)
            tick(kTick, false);
        COMPARE_NEAR(schedule.ceiling().value, ceilingAt(kTick), 1e-9, "N/m");
    }

    /// Under load it comes back no faster than an edit may change the force.
    void underLoadItComesBackAsAnEditDoes() {
        StiffnessSchedule schedule(DeviceInfo{});
        DeviceSample seen;
        ScheduleInput input{
            .seen = seen, .late = true, .stiffness = 1e6, .rendered = 500, .load = 2, .pushing = true};
        input.dt = 4e-3;
        for (int i = 0; i < 6; ++i)
            schedule(input);
        input.late = false;
        input.dt = kTick;
        double before = schedule.period();
        for (int i = 0; i < 100; ++i) {
            schedule(input);
            QCOMPARE_GE(schedule.period(), before * (1 - 7.5 * kTick / 2) - 1e-15); // 15 mm/s times 500 N/m
            before = schedule.period();
        }
    }

    void whatGivesEnergyIsSoftenedAndComesBackFree() {
        StiffnessSchedule schedule(DeviceInfo{});
        DeviceSample seen;
        ScheduleInput input{.seen = seen, .stiffness = 100, .rendered = 100, .load = 1, .pushing = true};
        for (int i = 0; i < 100; ++i)
            QCOMPARE(schedule(input).stiffness, 100.0);
        input.made = 3.1e-3;
        double last = 1;
        for (int i = 0; i < 13; ++i) {
            schedule(input);
            QCOMPARE_LE(last - schedule.scale(), 0.5 * kTick / 0.0125 + 1e-12); // half of it in 12.5 ms
            last = schedule.scale();
        }
        COMPARE_NEAR(last, 0.5, 0.03, "");
        input.made = 2.9e-3;
        for (int i = 0; i < 1000; ++i)
            schedule(input);
        QCOMPARE_LE(schedule.scale(), last); // not under load
        input.load = 0;
        for (int i = 0; i < 3000; ++i)
            schedule(input);
        QCOMPARE(schedule.scale(), 1.0);
        QCOMPARE(schedule.oscillations(), 0u);
    }

    /// The whole hand bears more, from the next contact on; that it lets go is believed at once.
    void aGraspIsBelievedFromTheNextContactOn() {
        DeviceInfo device;
        device.handDamping = 1;
        const double pinch = safeStiffness(loopFigures(device)).value;
        StiffnessSchedule schedule(device);
        DeviceSample seen;
        ScheduleInput input{
            .seen = seen, .grasped = true, .stiffness = 1e6, .rendered = 500, .load = 1, .pushing = true};
        COMPARE_NEAR(schedule(input).stiffness, pinch, 1e-9, "N/m");
        input.load = 0;
        COMPARE_NEAR(schedule(input).stiffness, 1.7 * pinch, 1e-9, "N/m");
        input.load = 1;
        COMPARE_NEAR(schedule(input).stiffness, 1.7 * pinch, 1e-9, "N/m");
        QVERIFY(schedule.grasping());
        input.grasped = false;
        COMPARE_NEAR(schedule(input).stiffness, pinch, 1e-9, "N/m");
    }

    /// What a hand takes up it is not softened for: 3 mJ between two fingers, 1.7 times that in a whole hand.
    void aGraspTakesUpMore() {
        for (const bool grasped : {false, true}) {
            const double most = grasped ? 5.1e-3 : 3e-3;
            StiffnessSchedule schedule(DeviceInfo{});
            DeviceSample seen;
            ScheduleInput input{.seen = seen, .grasped = grasped, .stiffness = 100, .rendered = 100};
            schedule(input);
            input.load = 1;
            input.pushing = true;
            input.made = 0.99 * most;
            for (int i = 0; i < 100; ++i)
                schedule(input);
            QCOMPARE(schedule.scale(), 1.0);
            input.made = 1.01 * most;
            for (int i = 0; i < 13; ++i)
                schedule(input);
            COMPARE_NEAR(schedule.scale(), 0.5, 0.03, "");
        }
    }

    /// More than taps in a grasp bear it gives to nobody, and takes nothing from whom damping alone lets be
    /// stiffer.
    void aGraspHasACeilingOfItsOwn() {
        DeviceSample seen;
        for (const double damping : {0.0, 1.0, 2.0}) {
            DeviceInfo device;
            device.damping = damping;
            const double pinch = safeStiffness(loopFigures(device)).value;
            StiffnessSchedule schedule(device);
            const double grasp = schedule({.seen = seen, .grasped = true, .stiffness = 1e6}).stiffness;
            COMPARE_NEAR(grasp, std::max(pinch, 1850.0), 1e-9, "N/m");
        }
    }

    /// Two softened contacts are an accident, the third within minutes is none; half an hour apart they are.
    void aGraspThatIsNoneIsDoubted() {
        DeviceSample seen;
        for (const double apart : {10.0, 600.0}) {
            StiffnessSchedule schedule(DeviceInfo{});
            const auto go = [&](double seconds, double load, bool tooMuch, bool grasped = true) {
                for (double time = 0; time < seconds; time += kTick)
                    schedule({.seen = seen,
                              .grasped = grasped,
                              .stiffness = 1e6,
                              .rendered = 500,
                              .load = load,
                              .pushing = true,
                              .made = tooMuch ? 6e-3 : 0});
            };
            go(1, 0, false);
            for (int contact = 1; contact <= 3; ++contact) {
                QVERIFY(schedule.grasping());
                go(0.01, 1, true);
                go(0.01, 1, false);
                go(apart, 0, false);
            }
            QCOMPARE(schedule.grasping(), apart > 60);
            QCOMPARE(schedule.doubted(), apart < 60);
            go(600, 0, false); // time alone does not bring it back
            QCOMPARE(schedule.doubted(), apart < 60);
            go(0.01, 0, false, false); // the person chooses anew
            go(0.01, 0, false);
            QVERIFY(schedule.grasping());
        }
    }

    /// A force that grows, turns around, weakens; and what explains it.
    void suddenIsWhatNothingExplains() {
        const Vec3 up(0, 0, 1), aside(1, 0, 0);
        COMPARE_NEAR(suddenChange(5 * up, 2 * up, {}), 3, 1e-12, "N");
        COMPARE_NEAR(suddenChange(2 * up, 5 * up, {}), -3, 1e-12, "N");
        COMPARE_NEAR(suddenChange(2 * aside, 5 * up, {}), 2, 1e-12, "N");
        COMPARE_NEAR(suddenChange(-2 * up, 5 * up, {}), 4, 1e-12, "N"); // a reversal counts twice at most
        COMPARE_NEAR(
            suddenChange(5 * up, 2 * up, {.stiffness = 1000, .way = 1e-3, .damping = 5, .speed = 0.2}), 1,
            1e-12, "N");
        QVERIFY(std::isnan(suddenChange(up * std::nan(""), up, {})) ||
                suddenChange(up * std::nan(""), up, {}) == 0);
    }
};

TACTUM_TEST(TestStiffnessSchedule)

} // namespace test_stiffness_schedule

#include "test_stiffness_schedule.moc"
