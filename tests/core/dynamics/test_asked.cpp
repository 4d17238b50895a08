// What a state is asked for, and what it answers where numbers end: the force of an elastic finger, what a
// joint does, where bodies are, what stands still.
//
// What would show that a test here is wrong: an arm's torque is weight times lever, a finger's force Hooke's
// law from the place where it began; both orders of a joint's bodies have the sign turned; what ran beyond
// all numbers falls freely afterwards.

#include <cmath>
#include <limits>

#include <QTest>

#include "tests/core/dynamics/mechanisms.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_asked {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kStep = 1e-3; // s

/// An arm of 0.8 kg that lies along x, 0.3 m from its hinge about z to its centre.
struct Arm {
    std::vector<RigidBody> bodies{bodyAt(1, Vec3(0.3, 0, 0), 0.8, Vec3(0.001, 0.02, 0.02))};
    Joint hinge = hingeAt(bodies, kWorldBody, 1, Vec3::Zero());
    double moment = 0.02 + 0.8 * 0.3 * 0.3; ///< about the hinge, kg m^2
    double weight = 0.8 * 9.81 * 0.3;       ///< of it about the hinge, N m

    double torque(std::span<const AppliedForce> forces = {}, double rate = 0) const {
        Running run(bodies, {hinge});
        run.state().v[0] = rate;
        return run.dynamics().jointForce(run.state(), kDown, forces, kStep, 0);
    }
};

/// A finger that presses along -z with 2 N when the point is at the origin, of 100 N/m and 3 N s/m.
AppliedForce finger() {
    AppliedForce force;
    force.force_W = Vec3(0.5, 0, -2);
    force.stiffness = 100;
    force.damping = 3;
    force.velocity_W = Vec3(0.1, 0, 0.2);
    force.start_W = Vec3(1, 2, 3);
    force.into_W = -Vec3::UnitZ();
    return force;
}

} // namespace

class AskedTest : public QObject {
    Q_OBJECT

private slots:
    void aStiffFingerIsConstant();
    void anElasticFingerPressesLessAsItGivesWay();
    void oneThatSticksGivesWayEveryWay();
    void noFingerPulls();
    void aFreeJointDoesNothing();
    void aSpringDoesWhatHookeSays();
    void aDamperDoesWhatTheRateSays();
    void aMotorDoesWhatItMay();
    void aStopHoldsTheWeight();
    void dryFrictionHoldsTheWeight();
    void theOtherWayRoundIsTheOtherSign();
    void itIsAskedAndNothingHappens();
    void bodiesAreWhereTheyAreDescribed();
    void whatGoesBeyondNumbersStandsStill();
};

void AskedTest::aStiffFingerIsConstant() {
    AppliedForce force = finger();
    force.stiffness = 0;
    COMPARE_NEAR(force.forceAt(Vec3(9, 9, 9), Vec3(1, 1, 1)), Vec3(0.5, 0, -2), 1e-15, "N");
}

// Along the way that it presses alone, and the whole force by the same part: a press that slides stays in its
// cone.
void AskedTest::anElasticFingerPressesLessAsItGivesWay() {
    const AppliedForce force = finger();
    const Vec3 at = force.start_W, still = force.velocity_W;
    COMPARE_NEAR(force.forceAt(at, still), Vec3(0.5, 0, -2), 1e-12, "N");
    COMPARE_NEAR(force.forceAt(at + Vec3(0, 0, -0.01), still), Vec3(0.25, 0, -1), 1e-12,
                 "N"); // 100 N/m by 10 mm
    COMPARE_NEAR(force.forceAt(at + Vec3(0, 0, 0.01), still), Vec3(0.75, 0, -3), 1e-12, "N");
    COMPARE_NEAR(force.forceAt(at, still - Vec3(0, 0, 0.2)), Vec3(0.35, 0, -1.4), 1e-12,
                 "N"); // 3 N s/m by 0.2 m/s
    COMPARE_NEAR(force.forceAt(at + Vec3(0.05, -0.02, 0), still + Vec3(1, 0, 0)), Vec3(0.5, 0, -2), 1e-12,
                 "N");
}

void AskedTest::oneThatSticksGivesWayEveryWay() {
    AppliedForce force = finger();
    force.sticks = true;
    const Vec3 at = force.start_W, still = force.velocity_W;
    COMPARE_NEAR(force.forceAt(at + Vec3(0.002, 0.003, -0.004), still + Vec3(0.1, 0, 0)),
                 Vec3(0.5 - 0.2 - 0.3, -0.3, -2 + 0.4), 1e-12, "N");
}

void AskedTest::noFingerPulls() {
    AppliedForce force = finger();
    for (const bool sticks : {false, true}) {
        force.sticks = sticks;
        const Vec3 at = force.start_W, still = force.velocity_W;
        COMPARE_NEAR(force.forceAt(at + Vec3(0, 0, -0.0201), still), Vec3(0, 0, 0), 1e-15, "N");
        COMPARE_NEAR(force.forceAt(at + Vec3(0, 0, -0.0199), still).z(), -0.01, 1e-12, "N");
        force.force_W = Vec3(0.5, 0, 1); // away from what it presses into
        COMPARE_NEAR(force.forceAt(at + Vec3(0, 0, 0.5), still), Vec3(0, 0, 0), 1e-15, "N");
        force = finger();
    }
}

void AskedTest::aFreeJointDoesNothing() {
    COMPARE_NEAR(Arm().torque(), 0, 1e-15, "N m");
}

void AskedTest::aSpringDoesWhatHookeSays() {
    Arm arm;
    arm.hinge.drives.push_back({.angular = true, .axis = 0, .stiffness = 2, .position = 0.4});
    COMPARE_NEAR(arm.torque(), 2 * 0.4, 1e-12, "N m");
    arm.hinge.drives.push_back({.angular = true, .axis = 0, .stiffness = 3, .position = -0.1});
    COMPARE_NEAR(arm.torque(), 2 * 0.4 - 3 * 0.1, 1e-12, "N m");
}

void AskedTest::aDamperDoesWhatTheRateSays() {
    Arm arm;
    arm.hinge.drives.push_back({.angular = true, .axis = 0, .damping = 0.01, .velocity = 1});
    COMPARE_NEAR(arm.torque({}, 5), 0.01 * (1 - 5), 1e-12, "N m");
}

void AskedTest::aMotorDoesWhatItMay() {
    Arm arm;
    arm.hinge.drives.push_back({.angular = true, .axis = 0, .damping = 1e6, .velocity = 4, .maxForce = 0.7});
    COMPARE_NEAR(arm.torque(), 0.7, 1e-9, "N m");
    COMPARE_NEAR(arm.torque({}, 9), -0.7, 1e-9, "N m");
}

void AskedTest::aStopHoldsTheWeight() {
    Arm arm;
    arm.hinge.limits.push_back({.angular = true, .axes = 1, .min = 0, .max = 1});
    COMPARE_NEAR(arm.torque(), arm.weight, 1e-9, "N m");
    // And what is pressed onto it: 2 N at its centre; half of its weight less when it is lifted by as much.
    const AppliedForce down{{0, {Quat::Identity(), Vec3(0, 0.3, 0)}}, Vec3(0, -2, 0)};
    Running run(arm.bodies, {arm.hinge});
    const Pose centre{Quat::Identity(), Vec3(0.3, 0, 0)};
    AppliedForce pressed = down;
    std::vector<Pose> poses(1);
    run.dynamics().posesOf(run.state(), poses);
    pressed.at = run.mechanism().places[0];
    pressed.at.pose = pressed.at.pose * (poses[0].inverse() * centre);
    COMPARE_NEAR(arm.torque({&pressed, 1}), arm.weight + 2 * 0.3, 1e-9, "N m");
    pressed.force_W = Vec3(0, 0.5 * 0.8 * 9.81, 0);
    COMPARE_NEAR(arm.torque({&pressed, 1}), 0.5 * arm.weight, 1e-9, "N m");
    pressed.force_W = Vec3(0, 2 * 0.8 * 9.81, 0); // it leaves its stop
    COMPARE_NEAR(arm.torque({&pressed, 1}), 0, 1e-12, "N m");
}

void AskedTest::dryFrictionHoldsTheWeight() {
    Arm arm;
    arm.hinge.frictions.push_back({true, 0, 3});
    COMPARE_NEAR(arm.torque(), arm.weight, 1e-9, "N m");
    arm.hinge.frictions[0].force = 1;
    COMPARE_NEAR(arm.torque(), 1, 1e-9, "N m");
    COMPARE_NEAR(arm.torque({}, 2), -1, 1e-9, "N m");
}

void AskedTest::theOtherWayRoundIsTheOtherSign() {
    Arm arm;
    std::swap(arm.hinge.a, arm.hinge.b);
    std::swap(arm.hinge.frameA, arm.hinge.frameB);
    arm.hinge.drives.push_back({.angular = true, .axis = 0, .stiffness = 2, .position = 0.4});
    Running run(arm.bodies, {arm.hinge});
    // On the coordinate of the link, which is the arm's turn: the same push there as the other one of -0.4.
    COMPARE_NEAR(std::abs(arm.torque()), 2 * 0.4, 1e-12, "N m");
    run.run(0.05, kStep, Vec3::Zero());
    QCOMPARE_LT(run.bodies()[0].centre.y(), -1e-3); // and it swings down
}

void AskedTest::itIsAskedAndNothingHappens() {
    Arm arm;
    arm.hinge.frictions.push_back({true, 0, 1});
    Running asked(arm.bodies, {arm.hinge}), other(arm.bodies, {arm.hinge});
    for (int i = 0; i < 50; ++i) {
        asked.run(kStep, kStep);
        other.run(kStep, kStep);
        (void)asked.dynamics().jointForce(asked.state(), kDown, {}, kStep, 0);
    }
    QCOMPARE_EQ(asked.state().q[0], other.state().q[0]);
    QCOMPARE_EQ(asked.state().v[0], other.state().v[0]);
    QCOMPARE_LT(asked.state().q[0], -1e-3);
}

void AskedTest::bodiesAreWhereTheyAreDescribed() {
    const Chain chain = chainOf(4);
    Running run(chain.bodies, chain.joints);
    run.run(0.2, kStep);
    std::vector<Pose> poses(6, Pose{Quat::Identity(), Vec3(7, 7, 7)});
    run.dynamics().posesOf(run.state(), poses);
    const std::vector<BodyState> bodies = run.bodies();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        COMPARE_NEAR(poses[i].translation, bodies[i].pose.translation, 1e-15, "m");
        COMPARE_NEAR(poses[i].rotation.angularDistance(bodies[i].pose.rotation), 0, 1e-12, "rad");
    }
    QCOMPARE_GT((poses[3].translation - chain.bodies[3].pose.translation).norm(), 0.05);
    for (const std::size_t beyond : {4u, 5u}) // where there is no body nothing is written
        COMPARE_NEAR(poses[beyond].translation, Vec3(7, 7, 7), 1e-15, "m");
    std::vector<Pose> two(2); // and no more than there is room for
    run.dynamics().posesOf(run.state(), two);
    COMPARE_NEAR(two[1].translation, poses[1].translation, 1e-15, "m");
}

void AskedTest::whatGoesBeyondNumbersStandsStill() {
    const std::vector<RigidBody> bodies{bodyAt(1, Vec3(0, 1, 0), 1e-3)};
    Running run(bodies, {});
    run.run(0.1, kStep);
    const Vec3 before = run.bodies()[0].pose.translation;
    COMPARE_NEAR(before.y(), 1 - 0.5 * 9.81 * 0.01, 1e-12, "m");
    QCOMPARE_EQ(run.dynamics().stoodStill(), std::uint64_t(0));
    const AppliedForce huge{run.mechanism().places[0], Vec3(std::numeric_limits<double>::max(), 0, 0)};
    run.run(kStep, kStep, kDown, {&huge, 1});
    QCOMPARE_EQ(run.dynamics().stoodStill(), std::uint64_t(1));
    COMPARE_NEAR(run.bodies()[0].pose.translation, before, 1e-15, "m");
    COMPARE_NEAR(run.bodies()[0].velocity, Vec3(0, 0, 0), 1e-15, "m/s");
    run.run(0.1, kStep); // it falls from there
    COMPARE_NEAR(run.bodies()[0].pose.translation.y(), before.y() - 0.5 * 9.81 * 0.01, 1e-12, "m");
    QCOMPARE_EQ(run.dynamics().stoodStill(), std::uint64_t(1));
}

TACTUM_TEST(AskedTest)

} // namespace test_asked

#include "test_asked.moc"
