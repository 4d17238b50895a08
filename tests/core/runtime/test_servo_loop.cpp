// The servo loop alone: the test is the proxy loop and publishes the model, or keeps silent.
#include <algorithm>
#include <thread>

#include <QTest>

#include "core/runtime/servo_loop.h"
#include "tests/core/runtime/patience.h"
#include "tests/core/runtime/probe_device.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_servo_loop {

using namespace tactum;

namespace {

constexpr double kSpring = 500, kDepth = 0.002;
constexpr double kPush = kSpring * kDepth;

std::atomic<std::int64_t> slept{0}; // ns, of a machine that the test sends to sleep

std::int64_t sleepersClock() noexcept {
    return monotonicNanoseconds() + slept;
}

/// A servo loop whose finger is pressed into the plane z = 0.
struct RunningServo {
    RunningServo() {
        probe->isOpen = true;
        probe->height = -kDepth;
    }
    ~RunningServo() { stop(); }

    void start() {
        thread = std::thread(
            [this] { servoLoop(*channels, device, device.info(), motors, watchdog, sleepersClock); });
    }
    void stop() {
        channels->stop = true;
        if (thread.joinable()) thread.join();
    }
    void publishModel() {
        LocalContactModel model;
        model.planes = 1;
        model.plane[0] = {Vec3::UnitZ(), 0};
        model.stiffness = kSpring;
        model.valid = true;
        model.anchoring = channels->finger.read().anchoring;
        channels->contactModel.write({model, 1});
    }
    /// Publishes models until the command is `wanted`.
    bool pushesSteadily(double wanted) {
        if (eventually([&] {
                publishModel();
                const InhibitReason why = channels->servoTelemetry.read().inhibit;
                if (why == InhibitReason::NotArmed) channels->armed = true;
                return std::abs(probe->push - wanted) < 1e-12;
            }))
            return true;
        qInfo("pushes with %g N instead of %g N", double(probe->push), wanted);
        return false;
    }

    std::shared_ptr<Probe> probe = std::make_shared<Probe>();
    ProbeDevice device{probe};
    DeviceWatchdog watchdog; // of nothing
    LeftHeat motors;
    std::unique_ptr<Channels> channels = std::make_unique<Channels>();
    std::thread thread;
};

bool isZero(const Exchange& exchange) {
    return exchange.force.isZero(0);
}

} // namespace

class TestServoLoop : public QObject {
    Q_OBJECT

private slots:
    void silentProxyLosesItsSayAndGetsItBack() {
        RunningServo servo;
        servo.channels->armed = true;
        servo.start();
        QVERIFY(servo.pushesSteadily(kPush));
        QVERIFY(eventually([&] { return servo.probe->push == 0; })); // nobody publishes: the watchdog
        QVERIFY(servo.pushesSteadily(kPush));
    }

    void modelOfNoStepGivesNoForce() {
        RunningServo servo;
        servo.channels->armed = true;
        servo.start();
        QVERIFY(eventually([&] { return servo.channels->servoTelemetry.read().ticks > 200; }));
        servo.stop();
        QVERIFY(std::all_of(servo.probe->log.begin(), servo.probe->log.end(), isZero));
    }

    /// Whoever watches over the device has let go of the hand meanwhile: the old force would be a kick.
    void afterAStallTheOldForceDoesNotGoOut() {
        RunningServo servo;
        servo.channels->armed = true;
        servo.start();
        QVERIFY(servo.pushesSteadily(kPush));
        servo.probe->pause = 50;
        QVERIFY(eventually([&] { return servo.probe->push == 0; }));
        servo.stop();
        int stalls = 0;
        for (const Exchange& each : servo.probe->log)
            if (each.dt > kStall) {
                QCOMPARE_EQ(each.force, Vec3(0, 0, 0));
                ++stalls;
            }
        QCOMPARE_GT(stalls, 0);
    }

    /// A laptop that was closed while its force was on.
    void afterTheMachineSleptTheOldForceDoesNotGoOut() {
        RunningServo servo;
        servo.channels->armed = true;
        servo.start();
        QVERIFY(servo.pushesSteadily(kPush));
        slept += std::int64_t(3600) * 1'000'000'000;
        QVERIFY(eventually([&] { return servo.probe->push == 0; }));
        QVERIFY(servo.pushesSteadily(kPush)); // softly, by itself
        servo.stop();
        const auto woke =
            std::ranges::find_if(servo.probe->log, [](const Exchange& e) { return e.dt > 3600; });
        QVERIFY(woke != servo.probe->log.end());
        QCOMPARE_EQ(woke->force, Vec3(0, 0, 0));
        QCOMPARE_EQ(std::next(woke)->force, Vec3(0, 0, 0));
    }

    void withheldForceComesBackByItsGain() {
        RunningServo servo;
        servo.channels->armed = true;
        servo.start();
        QVERIFY(servo.pushesSteadily(kPush));
        servo.channels->armed = false;
        QVERIFY(eventually([&] { return servo.probe->push == 0; }));
        servo.channels->armed = true;
        QVERIFY(servo.pushesSteadily(kPush));
        servo.stop();
        const std::vector<Exchange>& log = servo.probe->log;
        for (std::size_t i = 1; i < log.size(); ++i) {
            // The gain, the first gain or the surface that comes back, whichever is most.
            const double rise = kPush * log[i - 1].dt / kRise + kSpring * kReturnSpeed * log[i - 1].dt;
            QCOMPARE_LE(log[i].force.z(), log[i - 1].force.z() + rise * (1 + 1e-9));
        }
    }

    void unreadableFingerGivesNoForce_data() {
        QTest::addColumn<bool>("nonsense");
        QTest::newRow("the device has nothing new") << false;
        QTest::newRow("the position is no number") << true;
    }

    void unreadableFingerGivesNoForce() {
        QFETCH(bool, nonsense);
        RunningServo servo;
        servo.channels->armed = true;
        servo.start();
        QVERIFY(servo.pushesSteadily(kPush));
        (nonsense ? servo.probe->nonsense : servo.probe->valid) = nonsense;
        QVERIFY(servo.pushesSteadily(0));
        const ServoTelemetry& telemetry = servo.channels->servoTelemetry.read();
        QCOMPARE_GT(telemetry.invalidSamples, 0);
        QCOMPARE(telemetry.finger, Vec3(0, 0, -kDepth)); // the last one that was read
        // At once for what cannot be true; where there is nothing the device counts as lost after kLostAfter.
        QVERIFY(eventually([&] { return !servo.channels->finger.read().valid; }));
    }

    void lastCommandIsZero() {
        RunningServo servo;
        servo.channels->armed = true;
        servo.start();
        QVERIFY(servo.pushesSteadily(kPush));
        servo.stop();
        QCOMPARE_EQ(servo.probe->log.back().force, Vec3(0, 0, 0));
        QVERIFY(!isZero(servo.probe->log[servo.probe->log.size() - 2]));
    }

    void whoEndsLeavesTheHeatOfTheMotors() {
        RunningServo servo;
        servo.probe->continuousForce = 0.1; // a hundredth of what it heats by: warm within a moment
        servo.channels->armed = true;
        servo.start();
        QVERIFY(eventually([&] {
            servo.publishModel();
            return servo.channels->servoTelemetry.read().heat > 0.3;
        }));
        servo.stop();
        QCOMPARE(servo.motors.heat, servo.channels->servoTelemetry.read().heat);
        QCOMPARE_GT(servo.motors.at, 0);
        QCOMPARE_LE(servo.motors.at, monotonicNanoseconds());
    }

    void everyTickIsTraced() {
        RunningServo servo;
        servo.start();
        QVERIFY(eventually([&] { return servo.channels->servoTelemetry.read().ticks > 50; }));
        servo.stop();
        TracePoint point;
        double last = -1;
        std::size_t count = 0;
        for (; servo.channels->trace.pop(point); ++count) {
            QCOMPARE_GT(point.t, last);
            last = point.t;
        }
        QCOMPARE(count, servo.probe->log.size() - 1); // all but the farewell
    }
};

TACTUM_TEST(TestServoLoop)

} // namespace test_servo_loop

#include "test_servo_loop.moc"
