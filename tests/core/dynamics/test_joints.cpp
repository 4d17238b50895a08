// Joints one by one: what each leaves free, limits, springs, motors, friction.
//
// What would show that a test here is wrong: each expected number is a closed form of the one freedom that is
// left; a joint with another freedom, sign or axis gives another one (the axes are tried in turn, and both
// orders of the two bodies).

#include <cmath>
#include <numbers>

#include <QTest>

#include "tests/core/dynamics/mechanisms.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_joints {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double pi = std::numbers::pi;

/// A disc on a hinge along z through its centre.
struct Disc {
    double moment = 0.02;
    std::vector<RigidBody> bodies{bodyAt(1, Vec3::Zero(), 1, Vec3::Constant(0.02))};
    Joint hinge = hingeAt(bodies, kWorldBody, 1, Vec3::Zero());
};

double angleOf(Running& run) {
    return run.state().q[0];
}

Joint turnedRound(const Joint& joint) {
    Joint other = joint;
    std::swap(other.a, other.b);
    std::swap(other.frameA, other.frameB);
    return other;
}

int freedomsOf(std::vector<JointLimit> limits) {
    const std::vector<RigidBody> bodies{bodyAt(1, Vec3::Zero())};
    const Joint joint = jointAt(bodies, kWorldBody, 1, Vec3::Zero(), Quat::Identity(), std::move(limits));
    return compileMechanism(bodies, std::vector{joint})->vs;
}

} // namespace

class JointsTest : public QObject {
    Q_OBJECT

private slots:
    void eachLeavesItsFreedoms();
    void bothOrdersOfTheBodiesAreOne_data();
    void bothOrdersOfTheBodiesAreOne();
    void aBodyOnAFixedJointIsPartOfTheOther();
    void aSpringSwingsByItsFrequency();
    void aSpringOfAFreeJointIsTheSame();
    void aStiffSpringSettles();
    void aDriveInAccelerationsKnowsNoMass();
    void dampersOnAllAxesOfABallAreOne();
    void boundedDrivesOfABallKeepTheirBound_data();
    void boundedDrivesOfABallKeepTheirBound();
    void springsOnAllAxesOfABallOnlyTake();
    void aStiffPointHolds_data();
    void aStiffPointHolds();
    void aDampedRopeUnderLoadComesToRest_data();
    void aDampedRopeUnderLoadComesToRest();
    void nothingTurnsAThreadAboutItself();
    void aMotorHoldsItsSpeedUpToItsForce();
    void dryFrictionHoldsAndSlows();
    void aDetentSwingsAsAPendulumDoes();
    void aDetentHoldsUpToItsForce();
    void aLimitStopsWhatComes();
    void aRopeHolds();
    void aRopeNeitherStretchesNorTakesSpeed_data();
    void aRopeNeitherStretchesNorTakesSpeed();
    void aRopeOnAWheelHolds();
    void aConeHoldsWhatRunsRound();
    void aSoftLimitGivesWay();
    void turnsGoOnBeyondHalfATurn();
    void somethingThatNothingMovesGoesOn();
    void aBodyMayTurnAboutSomeAxesOnly();
    void nonsenseIsRefused();
};

void JointsTest::eachLeavesItsFreedoms() {
    const auto linear = [](AxisSet axes) { return lock(false, axes); };
    const auto turning = [](AxisSet axes) { return lock(true, axes); };
    QCOMPARE(freedomsOf({linear(7), turning(7)}), 0); // fixed
    QCOMPARE(freedomsOf({linear(7), turning(6)}), 1); // hinge
    QCOMPARE(freedomsOf({linear(6), turning(7)}), 1); // slider
    QCOMPARE(freedomsOf({linear(6), turning(6)}), 2); // cylinder
    QCOMPARE(freedomsOf({linear(4), turning(3)}), 3); // planar
    QCOMPARE(freedomsOf({linear(7), turning(1)}), 2); // universal
    QCOMPARE(freedomsOf({linear(7)}), 3);             // ball
    QCOMPARE(freedomsOf({}), 6);                      // free
    QCOMPARE(freedomsOf({linear(1), linear(2), linear(4), turning(2), turning(1)}), 1);
}

// Not of all: which of a universal joint's axes stands on which body is another joint.
void JointsTest::bothOrdersOfTheBodiesAreOne_data() {
    QTest::addColumn<int>("linear");
    QTest::addColumn<int>("angular");
    QTest::newRow("hinge") << 7 << 6;
    QTest::newRow("slider") << 3 << 7;
    QTest::newRow("cylinder") << 6 << 6;
    QTest::newRow("planar") << 4 << 3;
    QTest::newRow("ball") << 7 << 0;
}

void JointsTest::bothOrdersOfTheBodiesAreOne() {
    QFETCH(int, linear);
    QFETCH(int, angular);
    std::vector<RigidBody> bodies{bodyAt(1, Vec3(0.2, 0.1, 0), 0.5, Vec3(0.01, 0.02, 0.025)),
                                  bodyAt(2, Vec3(0.4, -0.1, 0.1), 0.8, Vec3(0.02, 0.015, 0.03))};
    const Quat axes = Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
    std::vector<JointLimit> limits{lock(false, AxisSet(linear))};
    if (angular) limits.push_back(lock(true, AxisSet(angular)));
    Joint joint = jointAt(bodies, 1, 2, Vec3(0.3, 0, 0.05), axes, limits);
    joint.drives.push_back(
        {.angular = angular != 7, .axis = 0, .stiffness = 3, .damping = 0.1, .position = 0.1});
    const Joint root = hingeAt(bodies, kWorldBody, 1, Vec3::Zero());
    Running one(bodies, {root, joint});
    // Seen from the other body a coordinate has the other sign and, of a distance, the other body's axes.
    Joint other = turnedRound(joint);
    other.drives[0].position = -0.1;
    Running two(bodies, {root, other});
    one.run(0.5, 1e-3);
    two.run(0.5, 1e-3);
    for (std::size_t i = 0; i < 2; ++i) {
        COMPARE_NEAR(one.bodies()[i].centre, two.bodies()[i].centre, 1e-7, "m");
        COMPARE_NEAR(one.bodies()[i].pose.rotation.angularDistance(two.bodies()[i].pose.rotation), 0, 1e-6,
                     "rad");
    }
}

void JointsTest::aBodyOnAFixedJointIsPartOfTheOther() {
    std::vector<RigidBody> bodies{bodyAt(1, Vec3(0.3, 0, 0), 1, Vec3::Constant(0.01)),
                                  bodyAt(2, Vec3(0.6, 0, 0), 2, Vec3::Constant(0.02))};
    const Joint root = hingeAt(bodies, kWorldBody, 1, Vec3::Zero());
    const Joint weld = jointAt(bodies, 1, 2, Vec3(0.5, 0, 0), Quat::Identity(),
                               {lock(false, kAllAxes), lock(true, kAllAxes)});
    Running run(bodies, {weld, root});
    QCOMPARE(run.mechanism().vs, 1);
    Coordinates acceleration = Coordinates::Zero(1);
    run.dynamics().accelerations(run.state(), kDown, {}, acceleration);
    const double moment = 0.01 + 0.02 + 1 * 0.09 + 2 * 0.36;
    COMPARE_NEAR(acceleration[0], -9.81 * (0.3 + 1.2) / moment, 1e-10, "rad/s^2");
}

void JointsTest::aSpringSwingsByItsFrequency() {
    Disc disc;
    disc.hinge.drives.push_back({.angular = true, .axis = 0, .stiffness = 8, .position = 0.5});
    Running run(disc.bodies, {disc.hinge});
    run.run(0.73, 1e-3);
    COMPARE_NEAR(angleOf(run), 0.5 - 0.5 * std::cos(std::sqrt(8 / disc.moment) * 0.73), 1e-8, "rad");
}

// Measured between frames, not by a link: three springs that draw a point to a place.
void JointsTest::aSpringOfAFreeJointIsTheSame() {
    const std::vector<RigidBody> bodies{bodyAt(1, Vec3(0.1, 0.2, -0.3), 0.4)};
    Joint springs;
    springs.b = 1;
    for (int axis = 0; axis < 3; ++axis)
        springs.drives.push_back({.axis = axis, .stiffness = 40, .position = 0.5});
    Running run(bodies, {springs});
    run.run(1, 1e-3, Vec3::Zero());
    const Vec3 to = Vec3::Constant(0.5);
    COMPARE_NEAR(run.bodies()[0].centre, (to + std::cos(10.) * (Vec3(0.1, 0.2, -0.3) - to)), 1e-8, "m");
}

void JointsTest::aStiffSpringSettles() {
    Disc disc;
    disc.hinge.drives.push_back(
        {.angular = true, .axis = 0, .stiffness = 1e7, .damping = 1e3, .position = 0.5});
    Running run(disc.bodies, {disc.hinge});
    run.run(0.2, 1e-3);
    COMPARE_NEAR(angleOf(run), 0.5, 1e-6, "rad");
}

void JointsTest::aDriveInAccelerationsKnowsNoMass() {
    for (const double scale : {1e-4, 1., 1e4}) {
        Disc disc;
        disc.bodies[0].inertia *= scale;
        disc.hinge.drives.push_back(
            {.angular = true, .axis = 0, .stiffness = 100, .position = 1, .acceleration = true});
        Running run(disc.bodies, {disc.hinge});
        run.run(0.4, 1e-3);
        COMPARE_NEAR(angleOf(run), 1 - std::cos(10 * 0.4), 1e-7, "rad");
    }
}

// A ball about its own centre: omega = omega0 exp(-d t / I), however far round it is.
void JointsTest::dampersOnAllAxesOfABallAreOne() {
    constexpr double kMoment = 0.02, kDamping = 0.01;
    std::vector<RigidBody> bodies{bodyAt(1, Vec3::Zero(), 1, Vec3::Constant(kMoment))};
    bodies[0].angularVelocity = Vec3(3, -4, 5);
    Joint ball = ballAt(bodies, kWorldBody, 1, Vec3::Zero());
    for (const int axis : {0, 1, 2})
        ball.drives.push_back({.angular = true, .axis = axis, .damping = kDamping});
    Running run(bodies, {ball});
    for (const double t : {1., 2., 3.}) {
        run.run(1, 1e-3);
        COMPARE_NEAR(run.bodies()[0].angularVelocity,
                     Vec3(Vec3(3, -4, 5) * std::exp(-kDamping / kMoment * t)), 1e-9, "rad/s");
    }
}

// A body that hangs on drives with a bound, thrown round: each turns it back with its bound at most, so its
// turning changes by no more than three of them make, half a turn or not; and it only loses.
void JointsTest::boundedDrivesOfABallKeepTheirBound_data() {
    QTest::addColumn<double>("stiffness");
    QTest::addColumn<double>("damping");
    QTest::newRow("as both say") << 1. << 0.01;
    QTest::newRow("hardly damped") << 1. << 0.001;
    QTest::newRow("too stiff for the step") << 1e6 << 1e4;
}

void JointsTest::boundedDrivesOfABallKeepTheirBound() {
    QFETCH(double, stiffness);
    QFETCH(double, damping);
    constexpr double kMoment = 0.1, kMost = 2;
    std::vector<RigidBody> bodies{bodyAt(1, Vec3::Zero(), 1, Vec3::Constant(kMoment))};
    bodies[0].angularVelocity = Vec3(20, 30, 10);
    Joint ball = ballAt(bodies, kWorldBody, 1, Vec3::Zero());
    for (const int axis : {0, 1, 2})
        ball.drives.push_back(
            {.angular = true, .axis = axis, .stiffness = stiffness, .damping = damping, .maxForce = kMost});
    Running run(bodies, {ball});
    Vec3 before = run.bodies()[0].angularVelocity;
    const double start = run.bodies()[0].kinetic;
    double most = 0;
    for (int i = 0; i < 40000; ++i) {
        run.run(0.5e-3, 0.5e-3);
        const BodyState& now = run.bodies()[0];
        most = std::max(most, (now.angularVelocity - before).norm() * kMoment / 0.5e-3);
        before = now.angularVelocity;
        QCOMPARE_LT(now.kinetic, 1.02 * start);
    }
    QCOMPARE_LT(run.bodies()[0].kinetic, 0.9 * start);
    QCOMPARE_LT(most, std::sqrt(3.0) * kMost * 1.001);
}

// It goes round often, through half a turn about every axis.
void JointsTest::springsOnAllAxesOfABallOnlyTake() {
    std::vector<RigidBody> bodies{bodyAt(1, Vec3::Zero(), 1, Vec3::Constant(0.1))};
    bodies[0].angularVelocity = Vec3(20, 30, 10);
    Joint ball = ballAt(bodies, kWorldBody, 1, Vec3::Zero());
    for (const int axis : {0, 1, 2})
        ball.drives.push_back({.angular = true, .axis = axis, .stiffness = 1, .damping = 0.01});
    Running run(bodies, {ball});
    const auto energy = [&] { return run.bodies()[0].kinetic + run.dynamics().springEnergy(run.state()); };
    double most = energy();
    for (int i = 0; i < 40; ++i) {
        run.run(0.1, 0.5e-3);
        QCOMPARE_LT(energy(), 1.02 * most); // the springs' own turns at pi are sharp
        most = std::min(most, energy());
    }
    QCOMPARE_LT(energy(), 0.6 * 70); // exp(-2 d t / I) is 0.45
}

void JointsTest::aStiffPointHolds_data() {
    QTest::addColumn<double>("stiffness");
    for (const double stiffness : {1e5, 1e7, 1e9})
        QTest::addRow("%g N/m", stiffness) << stiffness;
}

// A limit of three axes that ends where it begins is a spring in all directions: what hangs on it a metre
// away swings as a pendulum.
void JointsTest::aStiffPointHolds() {
    QFETCH(double, stiffness);
    std::vector<RigidBody> bodies{bodyAt(1, Vec3(1, 0, 0), 1, Vec3::Constant(0.1))};
    const Joint point = jointAt(bodies, kWorldBody, 1, Vec3::Zero(), Quat::Identity(),
                                {{false, kAllAxes, 0, 0, stiffness, 100}});
    Running run(bodies, {point});
    for (int i = 0; i < 20; ++i) {
        run.run(0.1, 0.5e-3);
        QCOMPARE_LT(run.energy(), 0.01 * 9.81); // of what its fall has
        COMPARE_NEAR(run.bodies()[0].centre.norm(), 1, 1e-3, "m");
    }
}

void JointsTest::aDampedRopeUnderLoadComesToRest_data() {
    QTest::addColumn<double>("pull"); // m/s^2
    for (const double pull : {10., 100., 400., 1000.})
        QTest::addRow("%g m/s^2", pull) << pull;
}

// Rods of a quarter of a gram that hold 50 g: straight, a joint goes back by T l / d, here up to 25 times in
// a thousandth of a second, and its damper alone would stop the rod in a thirtieth of a step.
void JointsTest::aDampedRopeUnderLoadComesToRest() {
    QFETCH(double, pull);
    constexpr int kRods = 5;
    constexpr double kLength = 0.016;
    std::vector<RigidBody> bodies;
    std::vector<Joint> joints;
    const Vec3 along = Vec3(0.3, -1, 0.2).normalized();
    for (int i = 0; i < kRods; ++i)
        bodies.push_back(
            bodyAt(BodyId(i + 1), (i + 0.5) * kLength * along, 0.25e-3, Vec3(4.8e-9, 0.75e-9, 4.8e-9)));
    bodies.push_back(bodyAt(kRods + 1, (kRods + 1) * kLength * along, 0.05, Vec3::Constant(8e-6)));
    for (int i = 0; i <= kRods; ++i) {
        joints.push_back(ballAt(bodies, BodyId(i), BodyId(i + 1), i * kLength * along));
        if (i < kRods)
            for (const int axis : {0, 1, 2})
                joints.back().drives.push_back({.angular = true, .axis = axis, .damping = 2e-5});
    }
    joints.back().drives.push_back({.angular = true, .axis = 0, .damping = 1e-3});
    joints.back().drives.push_back({.angular = true, .axis = 1, .damping = 1e-3});
    joints.back().drives.push_back({.angular = true, .axis = 2, .damping = 1e-3});
    Running run(bodies, joints);
    const Vec3 gravity(0, -pull, 0);
    double before = run.energy(gravity);
    for (int i = 0; i < 40; ++i) {
        run.run(0.05, 0.5e-3, gravity);
        const double now = run.energy(gravity);
        QCOMPARE_LT(now, before + 1e-6);
        before = now;
    }
    QCOMPARE_EQ(run.dynamics().stoodStill(), std::uint64_t(0));
}

// Two threads of 0.1 g hold two bodies that a damped ball joins, one of which is pushed. What holds a thread
// by its ends has no arm about its axis, and so it never turns about that, by Euler's equation for what is
// round.
void JointsTest::nothingTurnsAThreadAboutItself() {
    const double length = 0.04;
    const Vec3 thin(1.1e-8, 9e-11, 1.1e-8), thick = Vec3::Constant(5e-8);
    std::vector<RigidBody> bodies;
    std::vector<Joint> joints;
    for (const double x : {0., 0.02}) {
        const BodyId thread = BodyId(bodies.size() + 1), body = thread + 1;
        bodies.push_back(bodyAt(thread, Vec3(x, length / 2, 0), 1e-4, thin));
        bodies.push_back(bodyAt(body, Vec3(x, -0.01, 0), 1e-3, thick));
        joints.push_back(ballAt(bodies, kWorldBody, thread, Vec3(x, length, 0)));
        joints.push_back(ballAt(bodies, thread, body, Vec3(x, 0, 0)));
    }
    Joint damped = ballAt(bodies, 2, 4, Vec3(0.01, -0.01, 0));
    for (const int axis : {0, 1, 2})
        damped.drives.push_back({.angular = true, .axis = axis, .damping = 1e-4});
    joints.push_back(damped);
    Running run(bodies, joints);
    const AppliedForce push{{run.mechanism().places[3].link, Pose{}}, Vec3(0, 0.05, 0.3)};
    double most = 0;
    for (int i = 0; i < 200; ++i) {
        run.run(0.5e-3, 0.5e-3, kDown, {&push, 1});
        for (const std::size_t thread : {0, 2}) {
            const BodyState& now = run.bodies()[thread];
            most = std::max(most, std::abs(now.pose.rotateInverse(now.angularVelocity).y()));
        }
    }
    QCOMPARE_GT(run.bodies()[2].angularVelocity.norm(), 1.0);
    QCOMPARE_LT(most, 1e-3);
}

void JointsTest::aMotorHoldsItsSpeedUpToItsForce() {
    Disc disc;
    disc.hinge.drives.push_back({.angular = true, .axis = 0, .damping = 1e6, .velocity = 4, .maxForce = 0.1});
    Running run(disc.bodies, {disc.hinge});
    run.run(0.3, 1e-3);
    COMPARE_NEAR(run.state().v[0], 0.1 / disc.moment * 0.3, 1e-9, "rad/s"); // all that it can
    run.run(0.7, 1e-3);
    COMPARE_NEAR(run.state().v[0], 4, 1e-5, "rad/s");
}

void JointsTest::dryFrictionHoldsAndSlows() {
    Disc disc;
    disc.hinge.frictions.push_back({true, 0, 0.05});
    disc.bodies[0].angularVelocity = Vec3(0, 0, 3);
    Running run(disc.bodies, {disc.hinge});
    run.run(0.5, 1e-3);
    COMPARE_NEAR(run.state().v[0], 3 - 2.5 * 0.5, 1e-10, "rad/s");
    run.run(2, 1e-3);
    COMPARE_NEAR(angleOf(run), 3 * 3 / (2 * 2.5), 1e-5, "rad"); // to within a part of one step
    const double stopped = angleOf(run);
    // A torque below it moves nothing.
    const auto push = [&](double force) { // x of the link is its axis, y the world's at the beginning
        const Quat back = Quat(Eigen::AngleAxisd(-angleOf(run), Vec3::UnitX()));
        const AppliedForce aside{{0, {Quat::Identity(), back * Vec3(0, 0.1, 0)}}, Vec3(-force, 0, 0)};
        run.run(5, 1e-3, kDown, {&aside, 1});
    };
    push(0.49); // 0.049 N m of the 0.05
    COMPARE_NEAR(angleOf(run), stopped, 1e-12, "rad");
    push(0.51);
    QCOMPARE_GT(angleOf(run) - stopped, 0.1);
}

// A detent is a pendulum in its angle 2 pi x / s: T = 4 sqrt(I / k) K(sin(theta / 2)), theta its amplitude.
void JointsTest::aDetentSwingsAsAPendulumDoes() {
    for (const double theta : {0.1, 1.5, 2.8}) {
        Disc disc;
        const double spacing = 0.3, stiffness = 0.8;
        disc.hinge.drives.push_back({.angular = true, .axis = 0, .stiffness = stiffness, .spacing = spacing});
        // It swings about the third detent.
        const double begin = 3 * spacing + theta * spacing / (2 * std::numbers::pi);
        Running run(disc.bodies, {disc.hinge});
        run.state().q[0] = begin;
        const double energy = run.dynamics().springEnergy(run.state());
        const double period =
            4 * std::sqrt(disc.moment / stiffness) * std::comp_ellint_1(std::sin(theta / 2));
        run.run(period, period / 4000);
        COMPARE_NEAR(angleOf(run), begin, 1e-6, "rad");
        COMPARE_NEAR(run.dynamics().springEnergy(run.state()) / energy, 1, 1e-5, "");
    }
}

// Its force is k s / 2 pi at most: less stays, more goes on.
void JointsTest::aDetentHoldsUpToItsForce() {
    for (const double part : {0.95, 1.05}) {
        Disc disc;
        const double spacing = 0.3, stiffness = 0.8, most = stiffness * spacing / (2 * std::numbers::pi);
        disc.hinge.drives.push_back(
            {.angular = true, .axis = 0, .stiffness = stiffness, .damping = 0.05, .spacing = spacing});
        Running run(disc.bodies, {disc.hinge});
        for (int i = 1; i <= 300; ++i) { // slowly: what swings goes beyond
            const AppliedForce push{{0, {Quat::Identity(), Vec3(0, 0.1, 0)}}, // x of the link is its axis
                                    Vec3(-part * most / 0.1 * std::min(1.0, i / 100.0), 0, 0)};
            run.run(0.05, 1e-3, Vec3::Zero(), {&push, 1});
            if (part > 1 && angleOf(run) > 0.5 * spacing) break;
        }
        QCOMPARE(angleOf(run) > 0.5 * spacing, part > 1);
    }
}

void JointsTest::aLimitStopsWhatComes() {
    Disc disc;
    disc.bodies[0].pose.translation = Vec3(0.2, 0, 0);
    disc.hinge = hingeAt(disc.bodies, kWorldBody, 1, Vec3::Zero());
    disc.hinge.limits.push_back({true, 1, -0.5, 0.2});
    Running run(disc.bodies, {disc.hinge});
    double lowest = 0;
    for (int i = 0; i < 1000; ++i) {
        run.run(1e-3, 1e-3);
        lowest = std::min(lowest, angleOf(run));
    }
    COMPARE_NEAR(lowest, -0.5, 1e-6, "rad");
    COMPARE_NEAR(angleOf(run), -0.5, 1e-6, "rad");
    COMPARE_NEAR(run.state().v[0], 0, 1e-9, "rad/s");
}

void JointsTest::aRopeHolds() {
    const std::vector<RigidBody> bodies{bodyAt(1, Vec3(0.1, 0, 0), 0.4)};
    Joint rope;
    rope.b = 1;
    rope.limits.push_back({false, kAllAxes, 0, 0.5});
    Running run(bodies, {rope});
    double longest = 0;
    for (int i = 0; i < 5000; ++i) {
        run.run(1e-3, 1e-3);
        longest = std::max(longest, run.bodies()[0].pose.translation.norm());
    }
    QVERIFY(longest > 0.49);
    // It swings through with v^2 = 2 g r: the way bends by v^2 dt^2 / 2 r in a step.
    COMPARE_NEAR(longest, 0.5, 9.81 * 1e-6, "m");
}

void JointsTest::aRopeNeitherStretchesNorTakesSpeed_data() {
    QTest::addColumn<double>("dt");
    QTest::addColumn<double>("tolerance");
    QTest::newRow("2 kHz") << 5e-4 << 1e-6;
    QTest::newRow("500 Hz") << 2e-3 << 2e-5;
}

// A stone on a rope of 1 m at 4 m/s, round and round: the polygon of its steps leaves the circle by
// (v dt)^2 / 8 r, 0.5 um at 2 kHz. Held where the rope points at the beginning of a step it was 0.6 mm too
// far.
void JointsTest::aRopeNeitherStretchesNorTakesSpeed() {
    QFETCH(double, dt);
    QFETCH(double, tolerance);
    std::vector<RigidBody> bodies{bodyAt(1, Vec3(1, 0, 0), 0.4)};
    bodies[0].velocity = {0, 4, 0};
    Joint rope;
    rope.b = 1;
    rope.limits.push_back({false, kAllAxes, 0, 1});
    Running run(bodies, {rope});
    double longest = 0, shortest = 1;
    for (int i = 0; i < 5 / dt; ++i) {
        run.run(dt, dt, Vec3::Zero());
        const double length = run.bodies()[0].pose.translation.norm();
        longest = std::max(longest, length), shortest = std::min(shortest, length);
    }
    COMPARE_NEAR(longest, 1, tolerance, "m");
    COMPARE_NEAR(shortest, 1, tolerance, "m"); // else it was no rope that it hung on
    COMPARE_NEAR(run.bodies()[0].velocity.norm(), 4, 1e-5, "m/s");
}

// From the rim of a wheel that turns with it: the point that it hangs on goes round, too.
void JointsTest::aRopeOnAWheelHolds() {
    std::vector<RigidBody> bodies{bodyAt(1, Vec3::Zero(), 1, Vec3::Constant(0.05)),
                                  bodyAt(2, Vec3(0.8, 0, 0), 0.2)};
    bodies[0].angularVelocity = {0, 0, 4};
    bodies[1].velocity = {0, 3.2, 0};
    Joint rope;
    rope.a = 1, rope.b = 2;
    rope.frameA.translation = {0.3, 0, 0};
    rope.limits.push_back({false, kAllAxes, 0, 0.5});
    Running run(bodies, {hingeAt(bodies, kWorldBody, 1, Vec3::Zero()), rope});
    const double before = run.energy(Vec3::Zero());
    double longest = 0, least = before;
    for (int i = 0; i < 2000; ++i) {
        run.run(5e-4, 5e-4, Vec3::Zero());
        const auto now = run.bodies(Vec3::Zero());
        longest = std::max(longest, (now[1].pose.translation - now[0].pose.apply({0.3, 0, 0})).norm());
        least = std::min(least, run.energy(Vec3::Zero()));
    }
    COMPARE_NEAR(longest, 0.5, 2e-6, "m");
    COMPARE_NEAR(least / before, 1, 1e-4, "");
}

// A rod in a ball joint without gravity runs round along its cone.
void JointsTest::aConeHoldsWhatRunsRound() {
    std::vector<RigidBody> bodies{bodyAt(1, Vec3::Zero(), 0.4, Vec3(2e-4, 2e-4, 1e-5))};
    bodies[0].pose.rotation = Eigen::AngleAxisd(0.5, Vec3::UnitX());
    // Its tip goes across: a turn about the axis that is across both, seen from its own middle.
    bodies[0].angularVelocity = bodies[0].pose.rotate(Vec3::UnitY()) * 6;
    Joint ball;
    ball.b = 1;
    ball.limits.push_back({false, kAllAxes, 0, 0});
    ball.limits.push_back({true, 3, -kUnbounded, 0.5});
    Running run(bodies, {ball});
    const double before = run.energy(Vec3::Zero());
    double widest = 0;
    for (int i = 0; i < 4000; ++i) {
        run.run(5e-4, 5e-4, Vec3::Zero());
        const Vec3 axis = run.bodies()[0].pose.rotate(Vec3::UnitZ());
        widest = std::max(widest, std::atan2(axis.head<2>().norm(), axis.z()));
    }
    COMPARE_NEAR(widest, 0.5, 1e-5, "rad");
    COMPARE_NEAR(run.energy(Vec3::Zero()) / before, 1, 1e-3, "");
}

void JointsTest::aSoftLimitGivesWay() {
    Disc disc;
    JointLimit soft{true, 1, -kUnbounded, 0.1};
    soft.stiffness = 8;
    disc.hinge.limits.push_back(soft);
    disc.bodies[0].angularVelocity = Vec3(0, 0, 2);
    Running run(disc.bodies, {disc.hinge});
    const double beyond = 0.03; // s after it is reached
    run.run(0.05 + beyond, 1e-4);
    const double w = std::sqrt(8 / disc.moment);
    COMPARE_NEAR(angleOf(run), 0.1 + 2 / w * std::sin(w * beyond), 1e-6, "rad");
}

void JointsTest::turnsGoOnBeyondHalfATurn() {
    Disc disc;
    disc.bodies[0].angularVelocity = Vec3(0, 0, 10);
    disc.hinge.limits.push_back({true, 1, -1, 3 * pi});
    Running run(disc.bodies, {disc.hinge});
    run.run(2, 1e-3);
    COMPARE_NEAR(angleOf(run), 3 * pi, 1e-6, "rad");
}

void JointsTest::somethingThatNothingMovesGoesOn() {
    RigidBody belt = bodyAt(1, Vec3::Zero());
    belt.kinematic = true;
    belt.velocity = Vec3(1, 0, 0);
    belt.angularVelocity = Vec3(0, 2, 0);
    std::vector<RigidBody> bodies{belt, bodyAt(2, Vec3(0, -0.5, 0), 3)};
    Running run(bodies, {ballAt(bodies, 1, 2, Vec3::Zero())});
    run.run(1, 1e-3);
    COMPARE_NEAR(run.bodies()[0].centre, Vec3(1, 0, 0), 1e-12, "m");
    COMPARE_NEAR(run.bodies()[0].angularVelocity, Vec3(0, 2, 0), 1e-12, "rad/s");
    // What hangs on it has not stayed behind.
    COMPARE_NEAR((run.bodies()[1].centre - run.bodies()[0].centre).norm(), 0.5, 1e-9, "m");
}

void JointsTest::aBodyMayTurnAboutSomeAxesOnly() {
    RigidBody body = bodyAt(1, Vec3::Zero(), 1, Vec3(0.1, 0, 0.1));
    body.angularVelocity = Vec3::Zero();
    Running run({body}, {});
    const AppliedForce push{{run.mechanism().places[0].link, {Quat::Identity(), Vec3(0.1, 0, 0)}},
                            Vec3(0, 0, 1)}; // a torque about -y, which is infinite
    run.run(0.5, 1e-3, Vec3::Zero(), {&push, 1});
    COMPARE_NEAR(run.bodies()[0].angularVelocity, Vec3::Zero(), 1e-12, "rad/s");
    COMPARE_NEAR(run.bodies()[0].velocity, Vec3(0, 0, 0.5), 1e-12, "m/s");
}

void JointsTest::nonsenseIsRefused() {
    RigidBody light = bodyAt(1, Vec3::Zero(), -1);
    QCOMPARE(refusal(compileMechanism(std::vector{light}, {})),
             std::string("body \"body 1\": has a negative mass or inertia; give positive ones, or 0 for what "
                         "nothing moves"));
    const std::vector<RigidBody> bodies{bodyAt(1, Vec3::Zero())};
    Joint joint = ballAt(bodies, kWorldBody, 1, Vec3::Zero());
    joint.b = 7;
    COMPARE_CONTAINS(refusal(compileMechanism(bodies, std::vector{joint})), "names a body that is not there");
    joint = ballAt(bodies, kWorldBody, 1, Vec3::Zero());
    joint.limits.push_back({true, 1, 2, 1});
    COMPARE_CONTAINS(refusal(compileMechanism(bodies, std::vector{joint})), "minimum is above its maximum");
}

TACTUM_TEST(JointsTest)

} // namespace test_joints

#include "test_joints.moc"
