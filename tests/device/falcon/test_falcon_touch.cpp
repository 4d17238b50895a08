// From the plug to the touch: the whole program's loops with the real driver, the real libusb and an emulated
// Falcon in an emulated hand that gives way.
#include <algorithm>

#include <QTest>

#include "core/runtime/local_engine.h"
#include "tests/core/runtime/patience.h"
#include "tests/core/surface/texture_rig.h"
#include "tests/device/falcon/falcon_bench.h"
#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/quiet.h"
#include "tests/support/test_program.h"

namespace test_falcon_touch {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kRadius = 1e-3;
constexpr double kWall = 500; ///< N/m
constexpr double kBallRadius = 0.03;
constexpr double kAbove = 0.01; ///< every surface

Material firm() {
    Material material = frictionless();
    material.stiffness = kWall;
    return material;
}

/// The plane z = 0.
std::shared_ptr<const World> wall() {
    return worldOf(sheet(0.05), firm(), kRadius);
}

/// A ball with its top in the origin, and noise of so many metres on it.
std::shared_ptr<const World> texturedBall(double height) {
    Pose pose;
    pose.translation = {0, 0, -kBallRadius};
    Scene scene = sceneOf(ball(kBallRadius, 5), firm(), kRadius, pose);
    scene.objects[0].surfaces[0].layers = {
        heightLayer(TextureSource::Noise, TextureMapping::Triplanar, 0.01, height)};
    return compile(scene).value();
}

/// A Falcon that is made ready by a person, and an engine that has it.
struct Touch {
    explicit Touch(std::shared_ptr<const World> theWorld) : bench(1), world(std::move(theWorld)) {}

    /// `loaded`: somebody had made it ready before.
    bool start(bool loaded = true) {
        if (loaded) bench.device->startFirmware(true);
        auto falcon = bench.driver();
        Person person(bench.device);
        if (const auto ready = falcon->prepare(person); !ready) {
            qWarning("%s", ready.error().text.c_str());
            return false;
        }
        bench.device->putGrip({0, 0, 0.01});
        driver = falcon.get();
        engine = std::make_unique<LocalEngine>(std::move(falcon));
        engine->publish(world);
        if (const auto started = engine->start(); !started) {
            qWarning("%s", started.error().text.c_str());
            return false;
        }
        engine->setOverrideCeiling(true); // a busy machine shall not make the wall softer
        engine->setArmed(true);
        return true;
    }

    /// The force has its full strength. A machine that is busy with others is late, and the proxy may begin
    /// anew where the grip is, below the surface: then the person arms anew and comes from above once more.
    bool pushes(const Vec3& goal) {
        engine->poll();
        const InhibitReason why = engine->servo().inhibit;
        const bool faulty = isFault(why);
        const bool fellThrough = goal.z() < 0 && engine->servo().gain == 1 && bench.device->gripArrived() &&
                                 engine->proxy().output.contacts == 0;
        if (!faulty && !fellThrough) return engine->servo().gain == 1;
        engine->setArmed(false);
        bench.device->leadGrip({goal.x(), goal.y(), kAbove});
        (void)eventually([&] {
            engine->poll();
            return bench.device->gripArrived() && engine->servo().finger.z() > 0.5 * kAbove &&
                   engine->servo().inhibit == InhibitReason::NotArmed;
        });
        engine->restartProxy();
        const std::uint64_t updates = engine->proxy().updates;
        (void)eventually([&] { return engine->poll(), engine->proxy().updates > updates + 2; });
        engine->setArmed(true);
        bench.device->leadGrip(goal);
        return false;
    }

    /// Leads the grip there and waits for rest; then the means of a fifth of a second with full force.
    struct Rest {
        Vec3 grip = Vec3::Zero(), force = Vec3::Zero(); ///< as the device has them
        bool found = false;
    };
    Rest restAt(const Vec3& goal) {
        bench.device->leadGrip(goal);
        constexpr int kSettle = 400, kMean = 200;
        Rest rest;
        int full = 0;
        const bool found = eventually([&] {
            full = pushes(goal) && bench.device->gripArrived() ? full + 1 : 0;
            if (full == 0) rest = {};
            if (full > kSettle) {
                rest.grip += bench.device->grip() / kMean;
                rest.force += bench.device->force() / kMean;
            }
            return rest.found = full == kSettle + kMean;
        });
        if (!found)
            qWarning("no rest: InhibitReason %d, %d contacts, the grip %s", int(engine->servo().inhibit),
                     engine->proxy().output.contacts,
                     bench.device->gripArrived() ? "is there" : "is on its way");
        return rest;
    }

    FalconBench bench;
    std::shared_ptr<const World> world;
    Falcon* driver = nullptr;
    std::unique_ptr<LocalEngine> engine;
};

/// How far apart commands reached the device, ms, sorted.
std::vector<double> periods(const EmulatedFalcon& device) {
    const std::vector<std::int64_t> times = device.commandTimes();
    std::vector<double> all;
    for (std::size_t i = 1; i < times.size(); ++i)
        all.push_back(1e-6 * double(times[i] - times[i - 1]));
    std::sort(all.begin(), all.end());
    return all;
}

QString text(const Vec3& v) {
    return QString("(%1 %2 %3)").arg(v.x()).arg(v.y()).arg(v.z());
}

} // namespace

class TestFalconTouch : public QObject {
    Q_OBJECT

private slots:
    void pressesOnAWall() {
        Touch touch(wall());
        QVERIFY(touch.start(false));
        const double grip = FalconBody::Hand{}.stiffness;
        for (const double depth : {0.006, 0.015}) {
            const auto rest = touch.restAt({0.004, -0.006, kRadius - depth});
            QVERIFY(rest.found);
            // Two springs in a row, the hand's and the wall's.
            const Vec3 answer(0, 0, depth * kWall * grip / (kWall + grip));
            const Vec3 ofThisPlace(0, 0, kWall * (kRadius - rest.grip.z()));
            qInfo("%g mm deep: %.4f N, %.4f N expected", 1e3 * depth, rest.force.z(), answer.z());
            COMPARE_NEAR(rest.force, answer, 0.02 * answer.norm(), "N");
            COMPARE_NEAR(rest.force, ofThisPlace, 0.02 * ofThisPlace.norm(), "N");
        }
        QCOMPARE_LT(touch.restAt({0, 0, 0.01}).force.norm(), 1e-9);
        QVERIFY(!touch.bench.device->overdriven());
        QVERIFY(!touch.bench.device->firstHadTorque());
        touch.engine->stop();
        QCOMPARE(touch.bench.device->motors(), FalconLegs{});
    }

    /// The answer is what a haptic step without any device says for a finger at that place.
    void feelsATexturedBall() {
        const auto world = texturedBall(1e-3);
        Touch touch(world);
        QVERIFY(touch.start());
        bool tilted = false;
        for (const Vec3& goal :
             {Vec3(0, 0, -0.012), Vec3(0.005, 0.003, -0.012), Vec3(-0.004, 0.006, -0.01)}) {
            const auto rest = touch.restAt(goal);
            QVERIFY(rest.found);
            Hand hand(world);
            hand.to({rest.grip.x(), rest.grip.y(), 0.01});
            hand.go(rest.grip, 0.05);
            for (int i = 0; i < 10; ++i)
                hand.to(rest.grip);
            const Vec3 answer = hand.output().force;
            qInfo("%s N, %s N expected", qPrintable(text(rest.force)), qPrintable(text(answer)));
            QCOMPARE_GT(answer.z(), 1);
            COMPARE_NEAR(rest.force, answer, 0.02 * answer.norm(), "N");
            // Without texture the force would point away from the ball's middle.
            const Vec3 smooth = (rest.grip - Vec3(0, 0, -kBallRadius)).normalized();
            tilted = tilted || answer.normalized().cross(smooth).norm() > 0.05;
            touch.restAt({0, 0, 0.01});
        }
        QVERIFY(tilted);
    }

    void keepsItsPace() {
        TACTUM_NEEDS_QUIET();
        Touch touch(wall());
        QVERIFY(touch.start());
        QVERIFY(touch.restAt({0, 0, -0.01}).found);
        const std::uint64_t begun = touch.engine->servo().ticks;
        QVERIFY(eventually([&] {
            touch.engine->poll();
            return touch.engine->servo().ticks > begun + 5000;
        }));
        const double rate = touch.engine->servo().rate;
        const bool realtime = touch.engine->hasRealtimePriority();
        const std::uint64_t invalid = touch.engine->servo().invalidSamples;
        const std::uint64_t ticks = touch.engine->servo().ticks;
        touch.engine->stop();
        const std::vector<double> all = periods(*touch.bench.device);
        const auto part = [&](double p) { return all[std::size_t(p * double(all.size() - 1))]; };
        qInfo("servo %.0f Hz; commands every %.3f ms (p50), %.3f (p99), %.3f (max) of %zu; "
              "%d of %d ticks without a new reading; %s",
              rate, part(0.5), part(0.99), all.back(), all.size(), int(invalid), int(ticks),
              realtime ? "real-time priority" : "no real-time priority");
        QCOMPARE_GT(part(0.5), 0.5);
        if (!realtime) QSKIP("Without real-time priority everybody may go first: no bounds.");
        QCOMPARE_GE(rate, 900);
        QCOMPARE_LT(part(0.99), 5);
    }

    void afterAFaultOnlyThePersonBringsTheForceBack_data() {
        QTest::addColumn<int>("fault");
        const char* names[] = {"silent", "an encoder jumps", "forgets its home", "no report is whole"};
        for (int i = 0; i < int(std::size(names)); ++i)
            QTest::addRow("%s", names[i]) << i;
    }
    void afterAFaultOnlyThePersonBringsTheForceBack() {
        QFETCH(int, fault);
        const FalconFaults faults[] = {{.silent = true},
                                       {.encoderJump = {0, 200, 0}},
                                       {.forgetsHome = true},
                                       {.shortReports = 1'000'000}};
        Touch touch(wall());
        QVERIFY(touch.start());
        QVERIFY(touch.restAt({0, 0, -0.01}).found);
        EmulatedFalcon& device = *touch.bench.device;
        QCOMPARE_NE(device.motors(), FalconLegs{});
        const int before = device.torqueCommands();
        device.setFaults(faults[fault]);
        QVERIFY(eventually([&] { return device.motors() == FalconLegs{}; }));
        QVERIFY(eventually([&] {
            touch.engine->poll();
            return touch.engine->servo().inhibit == InhibitReason::DeviceLost;
        }));
        // Two commands were on the way, three readings may be missed.
        const int pushed = device.torqueCommands() - before;
        QCOMPARE_LE(pushed, 10);

        device.setFaults({.encoderJump = fault == 1 ? FalconLegs{0, -200, 0} : FalconLegs{}});
        if (fault == 2) device.startFirmware(true);
        const std::uint64_t then = touch.engine->servo().ticks;
        const int torques = device.torqueCommands();
        QVERIFY(eventually([&] {
            touch.engine->poll();
            return touch.engine->servo().ticks > then + 500;
        }));
        QCOMPARE(device.torqueCommands(), torques);
        if (fault != 1) QCOMPARE_EQ(touch.driver->trouble(), "");
        touch.engine->setArmed(false);
        device.leadGrip({0, 0, 0.01});
        QVERIFY(eventually([&] {
            touch.engine->poll();
            return device.gripArrived() && touch.engine->servo().inhibit == InhibitReason::NotArmed;
        }));
        QCOMPARE(device.torqueCommands(), torques);
        touch.engine->restartProxy(); // it was lost below the sheet
        touch.engine->setArmed(true);
        QCOMPARE_GT(touch.restAt({0, 0, -0.01}).force.z(), 1);
    }

    void pulledOutInContact() {
        Touch touch(wall());
        QVERIFY(touch.start());
        QVERIFY(touch.restAt({0, 0, -0.01}).found);
        FalconBench::unplug();
        const std::uint64_t then = touch.engine->servo().ticks;
        QVERIFY(eventually([&] {
            touch.engine->poll();
            return touch.engine->servo().inhibit == InhibitReason::DeviceLost;
        }));
        qInfo("noticed within %d ticks", int(touch.engine->servo().ticks - then));
        COMPARE_CONTAINS(touch.driver->trouble(), "unplugged");
        touch.engine->stop();
        touch.bench.plug();
        touch.bench.device->putGrip({0, 0, 0.01});
        VERIFY_RESULT(touch.engine->start()); // firmware and home were kept: nobody is needed
        QCOMPARE(touch.bench.device->motors(), FalconLegs{});
        QVERIFY(!touch.engine->armed());
        QVERIFY(!touch.bench.device->firstHadTorque());
        touch.engine->setArmed(true);
        QCOMPARE_GT(touch.restAt({0, 0, -0.01}).force.z(), 1);
    }
};

TACTUM_TEST(TestFalconTouch)

} // namespace test_falcon_touch

#include "test_falcon_touch.moc"
