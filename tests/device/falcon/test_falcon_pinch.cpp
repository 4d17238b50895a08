// Two emulated Falcons on one engine, each with its driver, servo and guard, and a loose box between them:
// they lift it, hold it and lose it when it gets slippery. In simulated time and for every tick:
// test_stability_two_hands.
#include <array>
#include <optional>

#include <QTest>

#include "core/runtime/local_engine.h"
#include "tests/core/runtime/patience.h"
#include "tests/device/falcon/falcon_bench.h"
#include "tests/support/compare.h"
#include "tests/support/repeats.h"
#include "tests/support/test_program.h"
#include "tests/support/two_hands.h"

namespace test_falcon_pinch {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kMass = 0.05, kWeight = kMass * kGravity, kLift = 0.02;
constexpr double kAside = -2e-3, kReach = 0.015; ///< m, of the arm's goal beyond the side of the box
// A machine that stands still for 10 ms makes a guard let go: only a run without that is judged.
constexpr int kAttempts = 20;

Scene box(double friction) {
    Material feel = rough(friction, friction);
    feel.stiffness = 800;
    return boxOnFloor(kMass, feel);
}

class Pinch {
public:
    bool start() {
        engine = std::make_unique<LocalEngine>(driver(0));
        world_ = compile(box(0.9)).value();
        engine->publish(world_);
        if (!engine->start() || !engine->addDevice(driver(1))) return false;
        for (std::size_t i = 0; i < 2; ++i)
            engine->hand(i).setOverrideCeiling(true); // a busy machine shall not make the box softer
        return true;
    }
    /// Both arms go there, and the box may not be lost meanwhile. False when a guard let go.
    bool lead(double depth, double height) {
        for (std::size_t i = 0; i < 2; ++i)
            falcons_[i].device->leadGrip(placeOf(i, depth, height));
        bool well = true;
        return eventually([&] {
                   well = well && holds();
                   return !well || (falcons_[0].device->gripArrived() && falcons_[1].device->gripArrived());
               }) &&
               well;
    }
    /// From a box on the floor and forces off.
    bool lift() {
        engine->setAllArmed(false);
        for (std::size_t i = 0; i < 2; ++i)
            falcons_[i].device->putGrip(placeOf(i, kAside, 0));
        engine->beginBodies();
        ticks(300);
        for (std::size_t i = 0; i < 2; ++i)
            engine->hand(i).restartProxy();
        ticks(100);
        engine->setAllArmed(true);
        const bool armed = eventually([&] { return holds(); });
        return armed && lead(kReach, 0) && lead(kReach, kLift) && boxHeight() > 0.5 * kLift;
    }
    /// N, the mean of the forces on both fingers over so many seconds; nothing when a guard let go.
    std::optional<Vec3> hold(int seconds) {
        (void)means(); // of the way there
        std::array<Vec3, 2> sums{Vec3::Zero(), Vec3::Zero()};
        for (int i = 0; i < seconds; ++i) {
            const auto more = means();
            if (!more) return std::nullopt;
            for (std::size_t hand = 0; hand < 2; ++hand)
                sums[hand] += (*more)[hand] / seconds;
        }
        return Vec3(sums[0] + sums[1]);
    }
    void setFriction(double friction) {
        world_ = compile(box(friction), world_.get()).value();
        engine->publish(world_);
    }
    double boxHeight() {
        engine->poll();
        return engine->proxy().bodies.q[1];
    }
    double grip() {
        engine->poll();
        return 0.5 * (engine->hand(1).servo().force.x() - engine->servo().force.x());
    }
    bool holds() {
        engine->poll();
        return engine->servo().gain == 1 && engine->hand(1).servo().gain == 1;
    }

    std::unique_ptr<LocalEngine> engine;

private:
    std::unique_ptr<Falcon> driver(std::size_t hand) {
        FalconBench& bench = falcons_[hand];
        bench.device->startFirmware(true);
        auto falcon = bench.driver();
        Person person(bench.device);
        if (const auto ready = falcon->prepare(person); !ready) qWarning("%s", ready.error().text.c_str());
        bench.device->setHand({.speed = 0.03});
        bench.device->putGrip(placeOf(hand, kAside, 0));
        return falcon;
    }
    /// N, on each finger, over all ticks that nobody has asked for and a second of them at least.
    std::optional<std::array<Vec3, 2>> means() {
        constexpr int kSecond = 1000; // ticks
        std::array<Vec3, 2> sum{Vec3::Zero(), Vec3::Zero()};
        std::array<int, 2> seen{};
        bool well = true;
        const bool enough = eventually([&] {
            well = well && holds();
            for (std::size_t i = 0; i < 2; ++i)
                for (TracePoint point; engine->hand(i).popTrace(point); ++seen[i])
                    sum[i] += point.force;
            return !well || (seen[0] >= kSecond && seen[1] >= kSecond);
        });
        if (!enough || !well) return std::nullopt;
        return std::array{Vec3(sum[0] / seen[0]), Vec3(sum[1] / seen[1])};
    }
    static Vec3 placeOf(std::size_t hand, double depth, double height) {
        return {(hand == 0 ? -1 : 1) * (kBoxHalf + kFingertip - depth), height, 0};
    }
    void ticks(std::uint64_t count) {
        engine->poll();
        const std::uint64_t until = engine->servo().ticks + count;
        (void)eventually([&] { return engine->poll(), engine->servo().ticks > until; });
    }

    std::array<FalconBench, 2> falcons_{FalconBench(1, 2), FalconBench(1, 3)};
    std::shared_ptr<const World> world_;
};

} // namespace

class TestFalconPinch : public QObject {
    Q_OBJECT

private slots:
    void theyLiftABoxHoldItAndLoseItWhenItGetsSlippery() {
        Pinch pinch;
        QVERIFY(pinch.start());
        std::optional<Vec3> sum;
        for (int i = 0; i < kAttempts && !sum; ++i)
            if (pinch.lift()) sum = pinch.hold(repeats("TACTUM_HELD", 6)); // s
        QVERIFY2(sum, "it was not held even once");
        qInfo("grip %.3f N, sum of the forces %.4f %.4f %.4f N, weight %.4f N", pinch.grip(), sum->x(),
              sum->y(), sum->z(), kWeight);
        COMPARE_NEAR(sum->y(), -kWeight, 0.01 * kWeight, "N");
        COMPARE_NEAR(sum->x(), 0, 0.01 * kWeight, "N");
        QCOMPARE_GT(pinch.boxHeight(), 0.5 * kLift);

        const double critical = kWeight / 2 / pinch.grip();
        pinch.setFriction(0.5 * critical);
        // It slides down, turns between the fingers and ends on a face or on an edge: its middle is at most
        // kBoxHalf (sqrt(2) - 1) = 8.3 mm above where it stood.
        QVERIFY2(eventually([&] { return pinch.boxHeight() < 0.5 * kLift; }),
                 qPrintable(QString("it is held at %1 m").arg(pinch.boxHeight())));
    }
};

TACTUM_TEST(TestFalconPinch)

} // namespace test_falcon_pinch

#include "test_falcon_pinch.moc"
