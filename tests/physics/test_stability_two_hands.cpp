// Two hands on two devices with a servo and a guard each, and a loose box between them: what issue a pinch of
// two has to bring, from lifting to slipping.
//
// What would show that a test here is wrong: the box and both plants are bodies of Newton, so whatever holds
// it bears its weight; and it has to slip at half its weight over the grip, which is no number of any code.
#include <algorithm>
#include <array>
#include <cmath>

#include <QTest>

#include "tests/physics/as_connected.h"
#include "tests/physics/servo.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/support/two_hands.h"

namespace test_stability_two_hands {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kMass = 0.05, kWeight = kMass * kGravity, kLift = 0.03;

/// The product's haptic step for both, once a tick, when the second servo has told its finger.
class SharedStep {
public:
    explicit SharedStep(std::shared_ptr<const World> theWorld) : world(std::move(theWorld)) {}

    Vec3 box() const { return {shared.bodies.q[0], shared.bodies.q[1], shared.bodies.q[2]}; }

    std::shared_ptr<const World> world;
    WorldState shared;

private:
    class Side final : public Surroundings {
    public:
        Side(SharedStep& all, std::size_t which) : all_(all), which_(which) {}
        bool answer(const FingerSample& finger, double dt, LocalContactModel& model) override {
            return all_.answer(which_, finger, dt, model);
        }

    private:
        SharedStep& all_;
        std::size_t which_;
    };

    bool answer(std::size_t which, const FingerSample& finger, double dt, LocalContactModel& model) {
        if (!finger.valid) return false;
        HandStep& step = steps_[which];
        step.input = {.finger = finger.position,
                      .fingerVelocity = finger.velocity,
                      .found = finger.anchoring != step.state.model.anchoring,
                      .coupling = finger.coupling};
        step.state.model.anchoring = finger.anchoring;
        if (which == 1) hapticStep(*world, shared, steps_, dt);
        model = step.state.model;
        return model.valid;
    }

    std::array<HandState, 2> hands_;
    std::array<HandStep, 2> steps_{HandStep{hands_[0], {}}, HandStep{hands_[1], {}}};

public:
    std::array<Side, 2> sides{Side(*this, 0), Side(*this, 1)};
};

Bench falcon() {
    return benchOf(kFalconConnected, kGrasp);
}

/// Two Falcons, each in a hand, left and right of a box on a floor.
class Pinch {
public:
    explicit Pinch(double friction)
        : scene_(boxOnFloor(kMass, feel(friction))),
          step(compile(scene_).value()), servos{Servo(connectedInfo(kFalconConnected), step.sides[0]),
                                                Servo(connectedInfo(kFalconConnected), step.sides[1])},
          loops_{ClosedLoop(falcon(), servos[0].control(), 3, 1),
                 ClosedLoop(falcon(), servos[1].control(), 3, 2)} {
        for (std::size_t i = 0; i < 2; ++i)
            loops_[i].plant.place({sideOf(i) * (kBoxHalf + kFingertip + 2e-3), 0, 0});
        run(0.8, -2e-3, 0);
    }

    /// For so long the arms go evenly to a goal: `depth` in m beyond the sides of the box, at a height.
    template <class Seen> void run(double seconds, double depth, double height, Seen&& seen) {
        const double fromDepth = depth_, fromHeight = height_;
        const int ticks = int(std::lround(seconds * falcon().timing.rate));
        for (int i = 1; i <= ticks; ++i) {
            depth_ = fromDepth + (depth - fromDepth) * i / ticks;
            height_ = fromHeight + (height - fromHeight) * i / ticks;
            for (std::size_t hand = 0; hand < 2; ++hand) {
                loops_[hand].plant.setGoal({sideOf(hand) * (kBoxHalf + kFingertip - depth_), height_, 0});
                loops_[hand].tick();
            }
            seen();
        }
    }
    void run(double seconds, double depth, double height) {
        run(seconds, depth, height, [] {});
    }
    /// As the slider does it.
    void setFriction(double friction) {
        scene_.objects[0].surfaces[0].material = feel(friction);
        step.world = compile(scene_, step.world.get()).value();
    }
    /// N, what leaves for a device.
    const Vec3& command(std::size_t hand) const { return loops_[hand].command; }
    double grip() const { return 0.5 * (command(1).x() - command(0).x()); }
    void tamper(std::size_t hand, std::function<void(DeviceSample&)> how) {
        loops_[hand].tamper = std::move(how);
    }

private:
    static double sideOf(std::size_t hand) { return hand == 0 ? -1 : 1; }
    static Material feel(double friction) {
        Material feel = rough(friction, friction);
        feel.stiffness = 800;
        return feel;
    }

    Scene scene_;
    double depth_ = -2e-3, height_ = 0;

public:
    SharedStep step;
    std::array<Servo, 2> servos;

private:
    std::array<ClosedLoop, 2> loops_;
};

constexpr double kReach = 0.02; ///< m, of the arm's goal beyond the side: it presses with some newtons

} // namespace

class TestStabilityTwoHands : public QObject {
    Q_OBJECT

private slots:
    void theyLiftABoxHoldItForAMinuteAndLoseItWhenItGetsSlippery() {
        Pinch pinch(0.9);
        pinch.run(1, kReach, 0);
        pinch.run(1.5, kReach, kLift);
        pinch.run(2, kReach, kLift);
        QCOMPARE_GT(pinch.step.box().y(), 0.5 * kLift);

        const Vec3 begin = pinch.step.box();
        double farthest = 0, most = 0;
        Vec3 sum = Vec3::Zero();
        const int ticks = 60'000;
        pinch.run(60, kReach, kLift, [&] {
            const Vec3 both = pinch.command(0) + pinch.command(1);
            sum += both / ticks;
            most = std::max(most, std::abs(both.y() + kWeight));
            farthest = std::max(farthest, (pinch.step.box() - begin).norm());
        });
        qInfo("grip %.3f N, sum of the forces %.5f %.5f %.5f N, weight %.5f N, off by at most %.5f N, box "
              "%.2f um",
              pinch.grip(), sum.x(), sum.y(), sum.z(), kWeight, most, 1e6 * farthest);
        COMPARE_NEAR(sum.y(), -kWeight, 0.01 * kWeight, "N");
        COMPARE_NEAR(sum.x(), 0, 0.01 * kWeight, "N");
        QCOMPARE_LT(farthest, 1e-5);
        for (const Servo& servo : pinch.servos) {
            QCOMPARE(servo.state.gate.faults(), 0u);
            QCOMPARE(servo.state.gate.gain(), 1.0);
        }

        const double critical = kWeight / 2 / pinch.grip();
        double held = 0;
        for (double friction = 1.3 * critical; friction > 0.7 * critical; friction -= 0.02 * critical) {
            pinch.setFriction(friction);
            pinch.run(0.5, kReach, kLift);
            if (pinch.step.box().y() < begin.y() - 1e-3) break;
            held = friction;
        }
        qInfo("held at %.4f, critical %.4f", held, critical);
        COMPARE_NEAR(held, critical, 0.03 * critical, "");
        pinch.run(1, kReach, kLift);
        QCOMPARE_LT(pinch.step.box().y(), 1e-3); // on the floor again
    }

    // A device that sends nothing any more has its own fault; the other goes on.
    void oneGuardLeavesTheOtherAlone() {
        Pinch pinch(0.9);
        pinch.run(1, kReach, 0);
        QCOMPARE_GT(pinch.grip(), 0.5);
        pinch.tamper(0, [](DeviceSample& sample) { sample.valid = false; });
        pinch.run(1.1 * kLostAfter, kReach, 0);
        pinch.tamper(0, {});
        double most = 0;
        pinch.run(0.5, kReach, 0, [&] { most = std::max(most, pinch.command(0).norm()); });
        QCOMPARE(pinch.servos[0].state.gate.inhibit(), InhibitReason::DeviceLost);
        QCOMPARE(most, 0.0);
        QCOMPARE(pinch.servos[1].state.gate.faults(), 0u);
        QCOMPARE(pinch.servos[1].state.gate.gain(), 1.0);
    }
};

TACTUM_TEST(TestStabilityTwoHands)

} // namespace test_stability_two_hands

#include "test_stability_two_hands.moc"
