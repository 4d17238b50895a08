// The engine with a device whose finger the test leads: what reaches the device, and when.
#include <atomic>
#include <optional>
#include <thread>
#include <utility>

#include <QTest>

#include "core/haptics/compile.h"
#include "core/loop/metronome.h"
#include "core/loop/realtime_thread.h"
#include "core/port/own_limit.h"
#include "core/runtime/local_engine.h"
#include "tests/core/runtime/patience.h"
#include "tests/core/runtime/probe_device.h"
#include "tests/support/compare.h"
#include "tests/support/page_faults.h"
#include "tests/support/quiet.h"
#include "tests/support/test_program.h"

namespace test_engine {

using namespace tactum;

namespace {

constexpr double kRadius = 1e-3;
constexpr double kDepth = 2e-3;

std::shared_ptr<const TriangleSoup> plate() {
    TriangleSoup soup;
    soup.positions = {{-0.1, -0.1, 0}, {0.1, -0.1, 0}, {0.1, 0.1, 0}, {-0.1, 0.1, 0}};
    soup.triangles = {{0, 1, 2}, {0, 2, 3}};
    soup.surfaceOf = {0, 0};
    return std::make_shared<const TriangleSoup>(std::move(soup));
}

/// A plate in z = 0 of a given stiffness; recompiled as the editor does it.
std::shared_ptr<const World> plateWorld(double stiffness, const World* previous = nullptr) {
    static const std::shared_ptr<const TriangleSoup> geometry = plate();
    Scene scene;
    scene.proxyRadius = kRadius;
    SceneObject object;
    object.geometry = geometry;
    object.surfaces.resize(1);
    object.surfaces[0].material.stiffness = stiffness;
    scene.add(object);
    return compile(scene, previous).value();
}

/// An engine over a plate whose finger comes from above and rests `depth` below the touching height.
struct TouchedPlate {
    explicit TouchedPlate(double stiffness) : world(plateWorld(stiffness)) {}

    bool touch(double depth) {
        engine.publish(world);
        if (!engine.start()) return false;
        const bool seen = eventually([&] { return polled().proxy().updates > 10; });
        probe->height = kRadius - depth;
        return seen && eventually([&] { return polled().proxy().output.contacts > 0; });
    }
    const Engine& polled() {
        engine.poll();
        return engine;
    }
    bool pushesWith(double force) {
        return pushesUntil([&] { return std::abs(probe->push - force) < 1e-5 * force + 1e-12; });
    }
    /// A machine that stood still lets the
    /// proxy begin anew at the finger, in the plate: whoever holds it arms once more and comes from above
    /// again.
    template <class Condition> bool pushesUntil(Condition condition) {
        double wanted = 0;
        bool isAside = false;
        return eventually([&] {
            const InhibitReason why = polled().servo().inhibit;
            if (why == InhibitReason::NotArmed) engine.setArmed(true);
            const double z = engine.proxy().output.proxy.z();
            if (z < 0 && !isAside) {
                wanted = probe->height.exchange(0.01);
                isAside = true;
            }
            if (z < 0 && engine.servo().finger.z() > 2 * kRadius) engine.restartProxy();
            if (z > 2 * kRadius && isAside) {
                probe->height = wanted;
                isAside = false;
            }
            return !isAside && condition();
        });
    }

    std::shared_ptr<Probe> probe = std::make_shared<Probe>();
    std::shared_ptr<const World> world;
    LocalEngine engine{std::make_unique<ProbeDevice>(probe)};
};

/// Counts the Worlds alive and the ones that died on a thread other than the test's.
struct Census {
    std::atomic<int> alive{0}, diedElsewhere{0};
    std::thread::id home = std::this_thread::get_id();

    std::shared_ptr<const World> watched(std::shared_ptr<const World> world) {
        ++alive;
        const World* raw = world.get();
        return {raw, [this, world](const World*) {
                    --alive;
                    diedElsewhere += std::this_thread::get_id() != home;
                }};
    }
};

} // namespace

class TestEngine : public QObject {
    Q_OBJECT

private slots:
    void runsWithoutAWorld() {
        const auto probe = std::make_shared<Probe>();
        LocalEngine engine(std::make_unique<ProbeDevice>(probe));
        QVERIFY(!engine.running());
        QVERIFY(engine.start().has_value());
        engine.setArmed(true);
        QVERIFY(eventually([&] {
            engine.poll();
            return engine.servo().ticks > 300;
        }));
        QCOMPARE(engine.proxy().updates, 0u);
        QCOMPARE(engine.servo().force, Vec3(0, 0, 0));
        QVERIFY(!engine.priorityNote().empty());
        COMPARE_LACKS(engine.priorityNote(), "\n");
    }

    /// Of the step that its model is of; with the forces off as well.
    void aTickSaysWhatItTouchedAndWhatWasWanted() {
        TouchedPlate plate(500);
        QVERIFY(plate.touch(kDepth));
        TracePoint tick;
        QVERIFY(eventually([&] {
            plate.polled();
            while (plate.engine.popTrace(tick))
                continue;
            return tick.touched.contacts > 0 && std::abs(tick.wanted.z() - 500 * kDepth) < 1e-9;
        }));
        QCOMPARE(tick.touched.object, plate.world->bodies[0].object);
        QCOMPARE(tick.touched.surface, 0u);
        QCOMPARE(tick.touched.friction, ContactFriction::Smooth);
        QCOMPARE(tick.revision, plate.world->revision);
        QCOMPARE(tick.gain, 0.0);
        QVERIFY(!tick.limited);
        QCOMPARE(tick.force, Vec3(0, 0, 0));
    }

    void pressedFingerIsPushedOnlyWhenArmed() {
        TouchedPlate plate(500);
        QVERIFY(plate.touch(kDepth));
        QVERIFY(!plate.engine.armed());
        const std::uint64_t ticks = plate.polled().servo().ticks;
        QVERIFY(eventually([&] { return plate.polled().servo().ticks > ticks + 100; }));
        QCOMPARE(plate.probe->push.load(), 0.0);
        plate.engine.setArmed(true);
        QVERIFY(plate.pushesWith(500 * kDepth));
        plate.engine.setArmed(false);
        QVERIFY(eventually([&] { return plate.probe->push == 0; }));
    }

    void editIsFelt() {
        TouchedPlate plate(400);
        QVERIFY(plate.touch(kDepth));
        plate.engine.setArmed(true);
        QVERIFY(plate.pushesWith(400 * kDepth));
        const auto edited = plateWorld(900, plate.world.get());
        plate.engine.publish(edited);
        QVERIFY(plate.pushesWith(900 * kDepth));
        QVERIFY(eventually([&] { return plate.polled().proxy().worldRevision == edited->revision; }));
    }

    // An update may be under way, and its report on the way, when the World comes. Updates are counted before
    // and after the hand-over: this thread may be stopped in between for as long as the machine likes.
    void anEditIsFeltWithinTwoUpdates() {
        TouchedPlate plate(400);
        QVERIFY(plate.touch(kDepth));
        for (int i = 0; i < 200; ++i) {
            const auto edited = plateWorld(400 + i, plate.world.get());
            const std::uint64_t before = plate.polled().proxy().updates;
            plate.engine.publish(edited);
            const std::uint64_t after = plate.polled().proxy().updates;
            QVERIFY(eventually([&] { return plate.polled().proxy().worldRevision == edited->revision; }));
            QCOMPARE_GT(plate.engine.proxy().worldSince, before);
            QCOMPARE_LE(plate.engine.proxy().worldSince, after + 2);
        }
    }

    void absurdStiffnessStaysWithinTheDevicesLimit() {
        TouchedPlate plate(1e9);
        QVERIFY(plate.touch(0.05));
        plate.engine.setArmed(true);
        QVERIFY(plate.pushesWith(ProbeDevice::kMaxForce));
        QVERIFY(eventually([&] { return plate.polled().servo().clamped > 10; }));
        plate.engine.stop();
        for (const Exchange& exchange : plate.probe->log)
            QCOMPARE_LE(exchange.force.norm(), ProbeDevice::kMaxForce);
    }

    /// Of the device that could give four times as much, and of the World that asks for more still.
    void noMoreLeavesThanThePersonWants() {
        constexpr double kWanted = 2; // N
        TouchedPlate plate(500);
        VERIFY_RESULT(plate.engine.setDevice(
            std::make_unique<OwnLimit>(std::make_unique<ProbeDevice>(plate.probe), kWanted)));
        QCOMPARE(plate.engine.device().maxForce, kWanted);
        QVERIFY(plate.touch(2 * kWanted / 500));
        plate.engine.setArmed(true);
        QVERIFY(plate.pushesWith(kWanted));
        plate.engine.stop();
        for (const Exchange& exchange : plate.probe->log)
            QCOMPARE_LE(exchange.force.norm(), kWanted);
    }

    void restartPutsTheProxyOntoTheFinger() {
        TouchedPlate plate(500);
        QVERIFY(plate.touch(10 * kRadius));
        plate.engine.setArmed(true);
        QVERIFY(plate.pushesWith(500 * 10 * kRadius));
        plate.engine.restartProxy();
        QVERIFY(eventually([&] { return plate.probe->push == 0; }));
        QVERIFY(eventually([&] { return plate.polled().proxy().output.proxy.z() < -kRadius; }));
    }

    void aFrozenWindowCostsNoTick() {
        TACTUM_NEEDS_QUIET();
        TouchedPlate plate(500);
        QVERIFY(plate.touch(kDepth));
        const std::uint64_t before = plate.polled().servo().ticks;
        const std::uint64_t updates = plate.engine.proxy().updates;
        const ServoTelemetry was = plate.engine.servo();
        const std::int64_t begun = monotonicNanoseconds();
        while (monotonicNanoseconds() - begun < 10'000'000'000) {
        } // ten seconds in which nothing is polled and no event is handled
        const ServoTelemetry& is = plate.polled().servo();
        const auto ticks = is.ticks - before;
        // What the machine took is not ours: it is counted, and on an ordinary day it is little. A machine
        // that lives in another one may be stopped in the middle of a tick, which looks like ours; a window
        // that costs ticks costs all of them.
        const auto own = (is.misses - was.misses) - (is.machineMisses - was.machineMisses);
        qInfo("%d ticks, %d missed of our own", int(ticks), int(own));
        if (plate.engine.hasRealtimePriority()) { // without it everybody may go first
            QCOMPARE_LE(own, ticks / 1000);
            QCOMPARE_GE(ticks, 9000);
        }
        QCOMPARE_GE(plate.engine.proxy().updates - updates, ticks / 2);
        QCOMPARE_GT(plate.engine.proxy().output.contacts, 0);
    }

    void beforeTheFirstTouchNothingIsRecorded() {
        LocalEngine untouched(std::make_unique<ProbeDevice>(std::make_shared<Probe>()));
        QVERIFY(untouched.recorded().proxy.rows.empty());
        QVERIFY(untouched.start().has_value()); // and without a World
        QVERIFY(eventually([&] { return untouched.poll(), untouched.servo().ticks > 10; }));
        const RecordedRun run = untouched.recorded();
        QVERIFY(run.proxy.rows.empty());
        QVERIFY(!run.servo.rows.empty());
    }

    /// Every scene that was felt in the last minute belongs to the recording.
    void whatWasFeltIsRemembered() {
        TouchedPlate plate(500);
        QVERIFY(plate.touch(kDepth));
        std::shared_ptr<const World> world = plate.world;
        std::vector<std::uint64_t> revisions{world->revision};
        for (const double stiffness : {510.0, 520.0, 530.0}) {
            world = plateWorld(stiffness, world.get());
            plate.engine.publish(world);
            revisions.push_back(world->revision);
            QVERIFY(eventually([&] { return plate.polled().proxy().worldRevision == world->revision; }));
        }
        const RecordedRun run = plate.engine.recorded();
        for (std::size_t i = 0; i < revisions.size(); ++i) {
            const RecordedScene* scene = run.sceneOf(revisions[i]);
            QVERIFY(scene);
            QCOMPARE(scene->scene->objects[0].surfaces[0].material.stiffness, 500 + 10 * double(i));
        }
        QVERIFY(!run.sceneOf(revisions.back() + 1000));
    }

    /// A driver that does not come back: what the servo told last is not told for ever.
    void aServoThatStandsStillIsSeen() {
        TouchedPlate plate(500);
        QVERIFY(plate.touch(kDepth));
        QVERIFY(eventually([&] { return plate.polled().servo().rate > 0; }));
        QVERIFY(!plate.engine.servoStandsStill());
        plate.engine.setArmed(true);
        QVERIFY(plate.pushesWith(500 * kDepth));
        plate.probe->hangs = true;
        QVERIFY(eventually([&] { return plate.polled().servoStandsStill(); }));
        QCOMPARE(plate.engine.servo().rate, 0.0);
        QCOMPARE(plate.engine.servo().inhibit, InhibitReason::Stall);
        QVERIFY(plate.engine.servo().gain == 0 && plate.engine.servo().force.isZero(0));
        plate.probe->hangs = false;
        QVERIFY(eventually([&] { return !plate.polled().servoStandsStill(); }));
    }

    /// Nothing waits for ever: what its servo may still touch is left to it.
    void aDeviceThatNeverComesBackIsGivenUp() {
        TouchedPlate plate(500);
        QVERIFY(plate.touch(kDepth));
        plate.engine.setDeadMan(true);
        QVERIFY(eventually([&] { return plate.engine.recorded().servo.rows.size() > 10; }));
        const std::shared_ptr<Probe> hung = plate.probe;
        hung->hangs = true;
        QVERIFY(eventually([&] { return hung->hanging.load(); }));
        const int before = hung->exchanges;
        const std::int64_t begun = monotonicNanoseconds();
        const std::size_t rows = plate.engine.recorded().servo.rows.size();
        const Result<void> stopped = plate.engine.stop();
        const auto seconds = 1e-9 * double(monotonicNanoseconds() - begun);
        QVERIFY2(seconds > 0.9, qPrintable(QString::number(seconds)));
        QVERIFY(hung->hanging && hung->isOpen && hung->stopped);
        QVERIFY(!plate.engine.running());
        QVERIFY(!stopped);
        COMPARE_BEGINS(stopped.error().text, "Probe did not come back");
        QCOMPARE_GT(rows, 10);
        QCOMPARE(plate.engine.recorded().servo.rows.size(), rows);
        const Result<void> again = plate.engine.start();
        QVERIFY(!again);
        COMPARE_BEGINS(again.error().text, "Probe did not come back");
        QVERIFY(!plate.engine.trouble().empty());

        plate.probe = std::make_shared<Probe>();
        plate.probe->buttons = 1;
        VERIFY_RESULT(plate.engine.setDevice(std::make_unique<ProbeDevice>(plate.probe)));
        QVERIFY(plate.engine.deadMan());
        plate.engine.setDeadMan(false);
        QVERIFY(eventually([&] { return plate.polled().proxy().updates > 10; }));
        plate.probe->height = kRadius - kDepth; // what was to be felt still is
        plate.engine.setArmed(true);
        QVERIFY(plate.pushesWith(500 * kDepth));
        // It comes back after all: one last command, of no force, and its thread ends.
        hung->hangs = false;
        QVERIFY(eventually([&] { return hung->exchanges == before + 1; }));
        QCOMPARE(hung->push.load(), 0.0);
        QVERIFY(plate.pushesWith(500 * kDepth));
    }

    /// A real device has a device watchdog, and what a fork shares is given anew page by page.
    void theLoopsOfARealDeviceFaultNoPages() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        QSKIP("the sanitizer's own memory faults");
#endif
        TouchedPlate plate(500);
        plate.probe->real = true;
        QVERIFY(plate.touch(kDepth));
        const auto tick = [&](std::uint64_t count) {
            const std::uint64_t before = plate.polled().servo().ticks;
            return eventually([&] { return plate.polled().servo().ticks > before + count; });
        };
        QVERIFY(tick(1000));
        const std::optional<long> servo = pageFaultsOf("tactum-servo"), proxy = pageFaultsOf("tactum-proxy");
        QVERIFY(servo && proxy);
        QVERIFY(tick(3000));
        QCOMPARE(*pageFaultsOf("tactum-servo") - *servo, 0L);
        QCOMPARE(*pageFaultsOf("tactum-proxy") - *proxy, 0L);
    }

    void stopSendsZeroThenCloses() {
        TouchedPlate plate(500);
        QVERIFY(plate.touch(kDepth));
        plate.engine.setArmed(true);
        QVERIFY(plate.pushesWith(500 * kDepth));
        plate.engine.stop();
        plate.engine.stop();
        QVERIFY(!plate.engine.running());
        QVERIFY(!plate.probe->isOpen);
        QCOMPARE(plate.probe->exchangesWhileClosed, 0);
        QCOMPARE(plate.probe->log.back().force, Vec3(0, 0, 0));
    }

    void destructorSendsZeroThenCloses() {
        auto plate = std::make_unique<TouchedPlate>(500);
        const std::shared_ptr<Probe> probe = plate->probe;
        QVERIFY(plate->touch(kDepth));
        plate->engine.setArmed(true);
        QVERIFY(plate->pushesWith(500 * kDepth));
        plate.reset();
        QVERIFY(!probe->isOpen);
        QCOMPARE(probe->exchangesWhileClosed, 0);
        QCOMPARE(probe->log.back().force, Vec3(0, 0, 0));
    }

    void startsAgainWithTheSameWorldAndForcesOff() {
        TouchedPlate plate(500);
        QVERIFY(plate.touch(kDepth));
        plate.engine.setArmed(true);
        QVERIFY(plate.pushesWith(500 * kDepth));
        plate.engine.stop();
        plate.probe->height = 0.01;
        QVERIFY(plate.touch(kDepth));
        QVERIFY(!plate.engine.armed());
        QCOMPARE(plate.probe->push.load(), 0.0);
    }

    void anotherDeviceTakesOver() {
        TouchedPlate plate(500);
        QVERIFY(plate.touch(kDepth));
        plate.engine.setArmed(true);
        QVERIFY(plate.pushesWith(500 * kDepth));
        const std::shared_ptr<Probe> first = plate.probe;
        plate.probe = std::make_shared<Probe>();
        VERIFY_RESULT(plate.engine.setDevice(std::make_unique<ProbeDevice>(plate.probe)));
        QVERIFY(!first->isOpen);
        QCOMPARE_EQ(first->log.back().force, Vec3(0, 0, 0));
        QVERIFY(plate.probe->isOpen);
        QVERIFY(plate.engine.running());
        QVERIFY(!plate.engine.armed());
        QVERIFY(plate.touch(kDepth));
        plate.engine.setArmed(true);
        QVERIFY(plate.pushesWith(500 * kDepth));
    }

    void aDeviceThatDoesNotOpenTakesOverNothing() {
        TouchedPlate plate(500);
        QVERIFY(plate.touch(kDepth));
        const auto other = std::make_shared<Probe>();
        other->refusesToOpen = true;
        QVERIFY(!plate.engine.setDevice(std::make_unique<ProbeDevice>(other)));
        QVERIFY(!plate.engine.running());
        QVERIFY(!plate.probe->isOpen);
        other->refusesToOpen = false;
        VERIFY_RESULT(plate.engine.start());
        QVERIFY(other->isOpen);
    }

    /// A hand at half the scene's measure presses half as deep and meets twice the stiffness.
    void theWorkspaceLiesWhereThePersonWants() {
        TouchedPlate plate(500);
        VERIFY_RESULT(plate.engine.setWorkspace({.scale = 2, .offset = {0, 0, 0.02}}));
        QVERIFY(!plate.engine.setWorkspace({.scale = 0}));
        plate.probe->height = 0.01;
        plate.engine.publish(plate.world);
        VERIFY_RESULT(plate.engine.start());
        plate.engine.setArmed(true);
        QVERIFY(eventually([&] { return plate.polled().proxy().updates > 10; }));
        plate.probe->height = 0.5 * (kRadius - kDepth - 0.02);
        QVERIFY(plate.pushesWith(500 * kDepth));
        QCOMPARE(plate.polled().servo().handle_D.z(), plate.probe->height.load());
        COMPARE_NEAR(plate.engine.servo().finger.z(), kRadius - kDepth, 1e-12, "m");
        // Elsewhere: the proxy begins at the finger, and nothing is touched.
        VERIFY_RESULT(plate.engine.setWorkspace({.scale = 2, .offset = {0, 0, 0.04}}));
        QVERIFY(eventually(
            [&] { return plate.probe->push == 0 && plate.polled().proxy().output.contacts == 0; }));
        QCOMPARE(plate.engine.servo().faults, 0u);
        QVERIFY(plate.engine.armed());
    }

    // A device that was pulled out and put back, or another one in between: no peak force for hot motors.
    void hotMotorsStayHotOverAStop() {
        TouchedPlate plate(500);
        plate.probe->continuousForce = 0.1; // 1 N heats it to the brim within half a second
        QVERIFY(plate.touch(kDepth));
        plate.engine.setArmed(true);
        QVERIFY(plate.pushesUntil([&] { return plate.engine.servo().heat > 0.5; }));
        const std::int64_t begun = monotonicNanoseconds();
        plate.engine.stop();
        const double left = plate.engine.servo().heat;
        const auto isWarm = [&] {
            const double heat = plate.engine.servo().heat; // seen before the clock is
            const double past = 1e-9 * double(monotonicNanoseconds() - begun) + 0.01; // and a tick or two
            return heat <= left && heat >= left * std::exp(-past / kMotorTime);
        };
        QVERIFY(plate.engine.start().has_value()); // forces off: it can only cool
        QVERIFY(eventually([&] { return plate.polled().servo().ticks > 20; }));
        QVERIFY2(isWarm(), qPrintable(QString::number(plate.engine.servo().heat)));

        const auto other = std::make_shared<Probe>();
        other->name = "Another";
        other->continuousForce = 0.1;
        VERIFY_RESULT(plate.engine.setDevice(std::make_unique<ProbeDevice>(other)));
        QVERIFY(eventually([&] { return plate.polled().servo().ticks > 20; }));
        QCOMPARE(plate.engine.servo().heat, 0.0);

        plate.probe->refusesToOpen = true;
        QVERIFY(!plate.engine.setDevice(std::make_unique<ProbeDevice>(plate.probe)));
        plate.probe->refusesToOpen = false;
        VERIFY_RESULT(plate.engine.setDevice(std::make_unique<ProbeDevice>(plate.probe)));
        QVERIFY(eventually([&] { return plate.polled().servo().ticks > 20; }));
        QVERIFY2(isWarm(), qPrintable(QString::number(plate.engine.servo().heat)));
    }

    void deviceThatDoesNotOpenIsReported() {
        const auto probe = std::make_shared<Probe>();
        probe->refusesToOpen = true;
        LocalEngine engine(std::make_unique<ProbeDevice>(probe));
        const Result<void> started = engine.start();
        QVERIFY(!started);
        QCOMPARE(started.error().kind, Error::Kind::Machine);
        QVERIFY(!engine.running());
        engine.publish(plateWorld(500));
        engine.setArmed(true);
        engine.restartProxy();
        engine.poll();
        engine.stop();
        QVERIFY(probe->log.empty());
    }

    void everyWorldComesHome() {
        Census census;
        {
            TouchedPlate plate(500);
            QVERIFY(plate.touch(kDepth));
            std::shared_ptr<const World> last = plate.world;
            plate.world.reset();
            std::uint64_t taken = 0, seen = 0;
            for (int i = 0; i < 10'000; ++i) {
                last = plateWorld(i % 2 ? 500 : 800, last.get());
                plate.engine.publish(census.watched(last));
                if (i % 10 == 0) plate.engine.poll();
                // In bursts, so that the proxy loop takes some and others are replaced before it can.
                if (i % 100 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
                taken += plate.engine.proxy().worldRevision !=
                         std::exchange(seen, plate.engine.proxy().worldRevision);
            }
            QCOMPARE_GT(taken, 10);
            QVERIFY(eventually([&] {
                plate.engine.poll();
                return plate.engine.proxy().worldRevision == last->revision && census.alive == 1;
            }));
            plate.engine.publish(plateWorld(500, last.get()));
            plate.engine.stop();
            QCOMPARE(census.alive.load(), 0);
        }
        QCOMPARE(census.diedElsewhere.load(), 0);
    }

    void aDeviceOfNoRateIsRefused() {
        for (const double rate : {0.0, -1.0, std::nan(""), 1e12}) {
            const auto probe = std::make_shared<Probe>();
            probe->rate = rate;
            LocalEngine engine(std::make_unique<ProbeDevice>(probe));
            const auto refused = engine.start();
            QVERIFY(!refused.has_value());
            QVERIFY(!engine.running());
            COMPARE_CONTAINS(refused.error().text, "rate");
            QVERIFY(!probe->isOpen);
            probe->rate = 1000; // another driver
            QVERIFY(engine.start().has_value());
        }
    }

    void worldsPublishedBeforeTheStartAreReleasedToo() {
        Census census;
        {
            LocalEngine engine(std::make_unique<ProbeDevice>(std::make_shared<Probe>()));
            const std::shared_ptr<const World> twice = census.watched(plateWorld(500));
            for (int i = 0; i < 5; ++i)
                engine.publish(census.watched(plateWorld(500)));
            engine.publish(twice);
            engine.publish(twice);
            QCOMPARE(census.alive.load(), 1);
        }
        QCOMPARE(census.alive.load(), 0);
    }
};

TACTUM_TEST(TestEngine)

} // namespace test_engine

#include "test_engine.moc"
