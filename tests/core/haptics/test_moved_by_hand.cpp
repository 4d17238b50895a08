// Bodies with mass under the finger, through whole haptic steps.
//
// What would show that a test here is wrong: each expected number is a closed form of a mass on the finger's
// spring (half a swing, momentum, the balance of torques, Coulomb's acceleration); the data rows take other
// masses, springs and rates, at which the numbers are others.

#include <cmath>
#include <cstring>
#include <numbers>

#include <QTest>

#include "core/haptics/body_places.h"
#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"

namespace test_moved_by_hand {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double kRadius = 1e-3;
constexpr double kHalf = 0.05; // of the plate that is pushed, whose top is at z = 0
constexpr double kMoment = 1e-3;

Material material(double stiffness, double friction = 0) {
    Material m;
    m.stiffness = stiffness;
    m.damping = 0;
    m.staticFriction = m.dynamicFriction = friction;
    m.viscosity = 0;
    return m;
}

/// A plate with mass below z = 0 and its finger above it.
struct Pushed {
    Scene scene;

    Pushed(double mass, const Material& feel) {
        scene = sceneOf(plate(kHalf, 0.01), feel, kRadius, {Quat::Identity(), {0, 0, -0.005}});
        RigidBody body;
        body.id = 1;
        body.mass = mass;
        body.inertia = Vec3::Constant(kMoment);
        scene.objects[0].body = 1;
        scene.mechanics.bodies = {body};
        scene.mechanics.gravity = Vec3::Zero();
    }
    /// Only these axes stay free, about or along the world's through a point.
    Joint& hold(AxisSet linear, AxisSet angular, const Vec3& at = Vec3::Zero()) {
        Joint joint;
        joint.b = 1;
        joint.frameA.translation = joint.frameB.translation = at;
        joint.collide = true;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(linear >> axis & 1)) joint.limits.push_back({false, AxisSet(1 << axis), 0, 0});
            if (!(angular >> axis & 1)) joint.limits.push_back({true, AxisSet(1 << axis), 0, 0});
        }
        scene.mechanics.joints.push_back(joint);
        return scene.mechanics.joints.back();
    }
    Hand hand(double dt = 5e-4) const {
        Hand made(compile(scene).value(), dt);
        made.to({0, 0, 2 * kRadius});
        return made;
    }
};

BodyState bodyOf(const Hand& hand) {
    Dynamics dynamics(hand.world().moving->mechanism());
    DynamicState state = dynamics.startState();
    std::copy_n(hand.state.bodies.q.begin(), hand.state.bodies.qs, state.q.data());
    std::copy_n(hand.state.bodies.v.begin(), hand.state.bodies.vs, state.v.data());
    BodyState body;
    dynamics.describe(state, hand.world().scene->mechanics.gravity, {&body, 1});
    return body;
}

} // namespace

class MovedByHandTest : public QObject {
    Q_OBJECT

private slots:
    void aFreeBodyBouncesOffAFingerThatGoesOn_data();
    void aFreeBodyBouncesOffAFingerThatGoesOn();
    void aPushBesideTheCentreTurns();
    void aDoorStaysWhereItsSpringHoldsIt();
    void aJointTellsWhatItDoes();
    void frictionTakesASlideAlong_data();
    void frictionTakesASlideAlong();
    void whatSlipsIsDraggedByCoulombsForce();
    void aPinchedBodyRestsBetweenFingerAndWall();
    void bodiesGiveNoMoreThanTheyGot();
    void noBodyGetsMoreThanTheDeviceGives();
    void lightBodiesStayWithTheFinger_data();
    void lightBodiesStayWithTheFinger();
    void theSameBitsFromAKeptState();
    void anotherMassKeepsTheMotionAnotherPlaceBeginsAnew();
    void scaledTheHandFeelsTheSame_data();
    void scaledTheHandFeelsTheSame();
    void tooManyCoordinatesAreRefused();
};

void MovedByHandTest::aFreeBodyBouncesOffAFingerThatGoesOn_data() {
    QTest::addColumn<double>("mass");
    QTest::addColumn<double>("stiffness");
    QTest::addColumn<double>("dt");
    QTest::newRow("half a kilogram") << 0.5 << 800.0 << 5e-4;
    QTest::newRow("ten grams") << 0.01 << 800.0 << 1e-4;
    QTest::newRow("hard") << 0.2 << 3000.0 << 2e-4;
}

// Seen from a finger at v the body comes with -v and leaves with v: 2 v in the world, after half a swing.
void MovedByHandTest::aFreeBodyBouncesOffAFingerThatGoesOn() {
    QFETCH(double, mass);
    QFETCH(double, stiffness);
    QFETCH(double, dt);
    const double v = 0.1, swing = std::sqrt(stiffness / mass);
    Hand hand = Pushed(mass, material(stiffness)).hand(dt);
    double momentum = 0, work = 0, strongest = 0, touched = 0;
    Vec3 before = hand.finger();
    hand.go({0, 0, 2 * kRadius - v * (1.3 * pi / swing + 0.012)}, v, [&](const Hand& now) {
        const double force = now.output().force.z();
        momentum += force * dt;
        work -= force * (now.finger() - before).z();
        strongest = std::max(strongest, force);
        touched += force > 0 ? dt : 0;
        before = now.finger();
    });
    const BodyState body = bodyOf(hand);
    const double part = 0.02 + swing * dt; // the hand's force is a step late
    COMPARE_NEAR(body.velocity.z(), -2 * v, 2 * v * part, "m/s");
    COMPARE_NEAR(momentum, 2 * v * mass, 2 * v * mass * part, "N s");
    COMPARE_NEAR(work, body.kinetic, body.kinetic * part, "J");
    COMPARE_NEAR(strongest, v * std::sqrt(stiffness * mass), strongest * part, "N");
    COMPARE_NEAR(touched, pi / swing, 2 * dt + part * pi / swing, "s");
    COMPARE_NEAR(body.velocity.head<2>().norm(), 0, 1e-9, "m/s");
}

// An impulse P at x from the centre: m v = P, I w = x P.
void MovedByHandTest::aPushBesideTheCentreTurns() {
    const double mass = 0.3, x = 0.02;
    Hand hand = Pushed(mass, material(800)).hand();
    hand.to({x, 0, 2 * kRadius});
    double momentum = 0;
    hand.go({x, 0, -0.002}, 0.1, [&](const Hand& now) { momentum += now.output().force.z() * 5e-4; });
    hand.to({x, 0, 0.05}); // let go
    const BodyState body = bodyOf(hand);
    QCOMPARE_GT(momentum, 0.005);
    COMPARE_NEAR(body.velocity.z(), -momentum / mass, 0.01 * momentum / mass, "m/s");
    COMPARE_NEAR(body.angularVelocity.y(), x * momentum / kMoment, 0.02 * x * momentum / kMoment, "rad/s");
    COMPARE_NEAR(body.angularVelocity.x(), 0, 1e-9, "rad/s");
}

// A torsion spring c against the finger's force at an arm x: c angle = x F.
void MovedByHandTest::aDoorStaysWhereItsSpringHoldsIt() {
    const double spring = 2, x = 0.04;
    Pushed door(0.3, material(800));
    Joint& hinge = door.hold(0, 2);
    hinge.drives.push_back({.angular = true, .axis = 1, .stiffness = spring, .damping = 0.1});
    Hand hand = door.hand();
    hand.to({x, 0, 2 * kRadius});
    hand.go({x, 0, -0.003}, 0.01);
    for (int i = 0; i < 6000; ++i)
        hand.to(hand.finger());
    const Quat turn = bodyOf(hand).pose.rotation;
    const double angle = 2 * std::atan2(turn.y(), turn.w());
    const Vec3 arm = hand.output().contact[0].point;
    const double torque = arm.cross(-hand.output().force).y();
    QCOMPARE_GT(angle, 0.01);
    COMPARE_NEAR(torque, spring * angle, 1e-4 * torque, "N m");
    // Along its way: (z0 - tip) of the finger's spring is what the door leaves.
    COMPARE_NEAR(hand.output().force.norm(), 800 * (hand.output().proxy - hand.finger()).norm(), 1e-9, "N");
}

// Under a finger at rest what a joint does is the opposite of what the finger does along it: by its spring,
// at its stop, by its dry friction.
void MovedByHandTest::aJointTellsWhatItDoes() {
    const double x = 0.04, press = 800 * 0.002;
    const auto told = [&](Pushed& door) {
        Hand hand = door.hand();
        hand.to({x, 0, 2 * kRadius});
        hand.go({x, 0, kRadius - 0.002}, 0.01);
        for (int i = 0; i < 6000; ++i)
            hand.to(hand.finger());
        const Vec3 arm = hand.output().contact[0].point;
        BodyPlaces places(&hand.world());
        const auto reading = places.readingOf(hand.state.bodies, 1, hand.output());
        return std::pair(reading.value(), arm.cross(-hand.output().force).y());
    };
    Pushed sprung(0.3, material(800));
    sprung.hold(0, 2).drives.push_back({.angular = true, .axis = 1, .stiffness = 2, .damping = 0.1});
    const auto [spring, push] = told(sprung);
    QVERIFY(spring.turns);
    QCOMPARE_GT(std::abs(push), 0.01);
    COMPARE_NEAR(spring.force, -push, 1e-4 * std::abs(push), "N m");
    COMPARE_NEAR(spring.force, -2 * spring.value, 1e-4 * std::abs(push), "N m");
    Pushed stopped(0.3, material(800));
    stopped.hold(0, 2).limits.push_back({true, 2, -1, 0});
    const auto [stop, heavy] = told(stopped);
    COMPARE_NEAR(std::abs(heavy), x * press, 0.02 * x * press, "N m");
    COMPARE_NEAR(stop.force, -heavy, 1e-3 * std::abs(heavy), "N m");
    Pushed dry(0.3, material(800));
    dry.hold(0, 2).frictions.push_back({true, 1, 1});
    const auto [friction, held] = told(dry);
    COMPARE_NEAR(std::abs(held), x * press, 0.02 * x * press, "N m");
    COMPARE_NEAR(friction.force, -held, 1e-3 * std::abs(held), "N m");
    Pushed sliding(0.3, material(800));
    sliding.hold(4, 0).drives.push_back({.axis = 2, .stiffness = 1000, .damping = 10});
    const auto slide = told(sliding).first;
    QVERIFY(slide.slides);
    COMPARE_NEAR(slide.force, -1000 * slide.value, 1e-9, "N");
    QCOMPARE_GT(slide.force, 0.5);
}

void MovedByHandTest::frictionTakesASlideAlong_data() {
    QTest::addColumn<double>("mass");
    QTest::addColumn<double>("stiffness");
    QTest::addColumn<double>("damping");
    QTest::newRow("soft") << 0.2 << 800.0 << 4.0;
    QTest::newRow("light and hard") << 0.02 << 5000.0 << 0.2; // held for a step, this would swing up
}

// Pressed 3 mm deep at a friction of 0.5 and taken along: the slide comes after the finger and rests on it.
void MovedByHandTest::frictionTakesASlideAlong() {
    QFETCH(double, mass);
    QFETCH(double, stiffness);
    QFETCH(double, damping);
    Pushed slide(mass, material(stiffness, 0.5));
    slide.hold(1, 0).drives.push_back({.axis = 0, .damping = damping});
    Hand hand = slide.hand();
    hand.go({0, 0, kRadius - 0.003}, 0.05);
    hand.go({0.02, 0, kRadius - 0.003}, 0.02);
    for (int i = 0; i < 4000; ++i)
        hand.to(hand.finger());
    COMPARE_NEAR(bodyOf(hand).centre.x(), 0.02, 1e-5, "m");
    COMPARE_NEAR(hand.output().force.x(), 0, 0.01, "N");
    COMPARE_NEAR(hand.output().force.z(), 0.003 * stiffness, 1e-6, "N");
}

// Faster than friction can: a = mu N / m until it is as fast.
void MovedByHandTest::whatSlipsIsDraggedByCoulombsForce() {
    const double mass = 1, press = 800 * 0.002, friction = 0.3;
    Pushed slide(mass, material(800, friction));
    slide.hold(1, 0);
    Hand hand = slide.hand();
    hand.to({-0.04, 0, 2 * kRadius});
    hand.go({-0.04, 0, kRadius - 0.002}, 0.05);
    hand.go({-0.01, 0, kRadius - 0.002}, 0.3);
    const double time = 0.1; // at 0.3 m/s the body, at no more than 0.05, is left behind
    COMPARE_NEAR(bodyOf(hand).velocity.x(), friction * press / mass * time,
                 0.03 * friction * press / mass * time, "m/s");
}

// Against a wall that a limit makes, 1 mm on: it does not swing, and the hand feels the wall's stiffness.
void MovedByHandTest::aPinchedBodyRestsBetweenFingerAndWall() {
    Pushed plate(0.02, material(5000));
    Joint& joint = plate.hold(4, 0);
    joint.limits.push_back({false, 4, -0.001, 0});
    Hand hand = plate.hand();
    hand.go({0, 0, kRadius - 0.002}, 0.1);
    for (int i = 0; i < 2000; ++i)
        hand.to(hand.finger());
    double least = 1e9, most = 0;
    for (int i = 0; i < 2000; ++i) {
        const double force = hand.to(hand.finger()).force.z();
        least = std::min(least, force), most = std::max(most, force);
    }
    COMPARE_NEAR(most, 5, 1e-3, "N");
    COMPARE_NEAR(most - least, 0, 1e-3, "N");
}

// A hand that wanders at random gets no more out of a body than it put in, but for what a finger that is
// told in steps always gains, half k of each step squared.
void MovedByHandTest::bodiesGiveNoMoreThanTheyGot() {
    Rng rng(7);
    for (int run = 0; run < 20; ++run) {
        const double stiffness = uniform(rng, 200, 3000), mass = std::pow(10, uniform(rng, -2, 0.3)),
                     dt = 5e-4;
        Pushed plate(mass, material(stiffness));
        Joint& joint = plate.hold(4, 0);
        joint.drives.push_back({.axis = 2, .stiffness = uniform(rng, 10, 500)});
        Hand hand = plate.hand(dt);
        double work = 0, leak = 0;
        Vec3 at = hand.finger(), velocity = Vec3::Zero();
        for (int i = 0; i < 8000; ++i) {
            velocity =
                0.99 * velocity + 0.01 * Vec3(0, 0, uniform(rng, -1, 1)) - 0.02 * (at - Vec3(0, 0, kRadius));
            const Vec3 way = velocity * dt;
            work -= hand.output().force.dot(way);
            leak += 0.5 * stiffness * way.squaredNorm();
            at += way;
            hand.to(at);
            const BodyState body = bodyOf(hand);
            const double spring =
                0.5 * plate.scene.mechanics.joints[0].drives[0].stiffness * body.centre.z() * body.centre.z();
            const double stretch = (hand.output().proxy - at).norm();
            const double held = body.kinetic + spring + 0.5 * stiffness * stretch * stretch;
            QCOMPARE_LE(held, work + leak + 1e-6 + 0.02 * held);
        }
        QCOMPARE_GT(leak, 1e-7);
    }
}

// 15 N of spring on a device of 3 N: the body gains 3 N / m each second, as the hand would feel it.
void MovedByHandTest::noBodyGetsMoreThanTheDeviceGives() {
    const double mass = 2, most = 3, dt = 5e-4;
    const auto world = compile(Pushed(mass, material(3000)).scene).value();
    SimState state;
    hapticStep(*world, state, {.finger = {0, 0, 2 * kRadius}, .coupling = {.force = most}}, dt);
    const int steps = 40;
    for (int i = 0; i <= steps; ++i)
        hapticStep(*world, state, {.finger = {0, 0, kRadius - 0.005}, .coupling = {.force = most}}, dt);
    Hand seen(world);
    seen.state = state;
    COMPARE_NEAR(bodyOf(seen).velocity.z(), -most / mass * steps * dt, 0.02 * most / mass * steps * dt,
                 "m/s");
}

void MovedByHandTest::lightBodiesStayWithTheFinger_data() {
    QTest::addColumn<double>("mass");
    for (const double mass : {0.02, 1e-3, 1e-5})
        QTest::addRow("%g kg", mass) << mass;
}

// On a soft spring: down to ten milligrams at 5 kN/m and 2 kHz the force dies out to the spring's.
void MovedByHandTest::lightBodiesStayWithTheFinger() {
    QFETCH(double, mass);
    const double soft = 100, stiffness = 5000;
    Pushed plate(mass, material(stiffness));
    Joint& joint = plate.hold(4, 0);
    joint.drives.push_back({.axis = 2, .stiffness = soft, .damping = 0.2});
    Hand hand = plate.hand();
    double strongest = 0;
    hand.go({0, 0, kRadius - 0.005}, 0.1,
            [&](const Hand& now) { strongest = std::max(strongest, now.output().force.norm()); });
    for (int i = 0; i < 4000; ++i)
        strongest = std::max(strongest, hand.to(hand.finger()).force.norm());
    const double both = soft * stiffness / (soft + stiffness);
    COMPARE_NEAR(hand.output().force.z(), both * 0.005, 1e-3, "N");
    QCOMPARE_LT(strongest, both * 0.005 + 2 * 0.1 * std::sqrt(stiffness * std::max(mass, 1e-4)) + 0.3);
}

// A replay begins at a state that was kept, in a World that stepped other things before.
void MovedByHandTest::theSameBitsFromAKeptState() {
    Pushed plate(0.1, material(800, 0.4));
    plate.scene.mechanics.gravity = {0, 0, -9.81};
    TouchMaterial smooth;
    smooth.staticFriction = smooth.dynamicFriction = 0.05;
    ColliderShape ground;
    ground.kind = ShapeKind::Plane;
    ground.size = {kUnbounded, 0, kUnbounded};
    const Pose lying{Quat(Eigen::AngleAxisd(pi / 2, Vec3::UnitX())), Vec3(0, 0, -0.01)};
    plate.scene.mechanics.colliders.push_back({kWorldBody, lying, ground, smooth, {}});
    ColliderShape box;
    box.size = {2 * kHalf, 2 * kHalf, 0.01};
    plate.scene.mechanics.colliders.push_back({1, {Quat::Identity(), Vec3(0, 0, -0.005)}, box, smooth, {}});
    Hand hand = plate.hand();
    hand.go({0.01, 0.002, kRadius - 0.002}, 0.1);
    const SimState kept = hand.state;
    hand.world().moving->forget();
    const auto goOn = [&] {
        hand.go({0.02, -0.01, kRadius - 0.001}, 0.1);
        hand.to({0.01, 0.002, kRadius - 0.002});
        return hand.state.bodies;
    };
    const BodiesState once = goOn();
    QVERIFY2(bodyOf(hand).centre.norm() > 1e-4, "it was not moved");
    hand.state = kept;
    hand.world().moving->forget();
    hand.to({0.01, 0.002, kRadius - 0.002});
    hand.state = kept;
    hand.world().moving->forget();
    const BodiesState again = goOn();
    QCOMPARE(std::memcmp(once.q.data(), again.q.data(), sizeof(double) * std::size_t(once.qs)), 0);
    QCOMPARE(std::memcmp(once.v.data(), again.v.data(), sizeof(double) * std::size_t(once.vs)), 0);
}

void MovedByHandTest::anotherMassKeepsTheMotionAnotherPlaceBeginsAnew() {
    Pushed plate(0.5, material(800));
    Hand hand = plate.hand();
    hand.go({0, 0, -0.002}, 0.1);
    const double fast = bodyOf(hand).velocity.z();
    QCOMPARE_LT(fast, -0.01);
    plate.scene.mechanics.bodies[0].mass = 5;
    hand.take(compile(plate.scene, &hand.world()).value());
    hand.to({0, 0, 0.05});
    QCOMPARE_LT(bodyOf(hand).velocity.z(), 0.9 * fast);
    plate.scene.mechanics.bodies[0].pose.translation.x() = 0.01;
    hand.take(compile(plate.scene, &hand.world()).value());
    hand.to({0, 0, 0.05});
    COMPARE_NEAR(bodyOf(hand).velocity.norm(), 0, 1e-12, "m/s");
}

void MovedByHandTest::scaledTheHandFeelsTheSame_data() {
    QTest::addColumn<double>("force");
    QTest::addColumn<double>("time");
    QTest::newRow("as it is") << 1.0 << 1.0;
    QTest::newRow("a micro-sensor") << 1e-5 << 1e-2;
    QTest::newRow("a windmill") << 100.0 << 4.0;
}

// x'' = F / m: where forces count S and seconds T, a body of S T^2 m goes the same way in the hand's time,
// and T times slower in its own.
void MovedByHandTest::scaledTheHandFeelsTheSame() {
    QFETCH(double, force);
    QFETCH(double, time);
    const auto run = [](double mass, double forceScale, double timeScale) {
        Pushed pushed(mass, material(800));
        pushed.scene.mechanics.forceScale = forceScale;
        pushed.scene.mechanics.timeScale = timeScale;
        Hand hand(compile(pushed.scene).value(), 5e-4);
        const auto to = [&](double z) {
            return hapticStep(hand.world(), hand.state,
                              {.finger = {0, 0, z}, .coupling = {.stiffness = 600, .delay = 2e-3}}, 5e-4);
        };
        to(2 * kRadius);
        double most = 0;
        for (int i = 0; i < 400; ++i)
            most = std::max(most, to(2 * kRadius - 4e-5 * i).force.z());
        return std::pair{bodyOf(hand), most};
    };
    const double mass = 0.1;
    const auto [plain, plainForce] = run(mass, 1, 1);
    const auto [scaled, scaledForce] = run(mass * force * time * time, force, time);
    QCOMPARE_LT(plain.velocity.z(), -0.05);
    COMPARE_NEAR(scaledForce, plainForce, 1e-6 * plainForce, "N");
    COMPARE_NEAR(scaled.centre.z(), plain.centre.z(), 1e-9, "m");
    COMPARE_NEAR(scaled.velocity.z() * time, plain.velocity.z(), 1e-6, "m/s");
}

void MovedByHandTest::tooManyCoordinatesAreRefused() {
    Pushed plate(0.5, material(800));
    for (BodyId id = 2; id <= 147; ++id) {
        plate.scene.mechanics.bodies.push_back(plate.scene.mechanics.bodies[0]);
        plate.scene.mechanics.bodies.back().id = id;
    }
    const auto refused = compile(plate.scene);
    QVERIFY(!refused);
    QVERIFY2(QString::fromStdString(refused.error().text).contains("1029 coordinates"),
             refused.error().text.c_str());
    plate.scene.mechanics.bodies.pop_back();
    QVERIFY(compile(plate.scene).has_value());
}

TACTUM_TEST(MovedByHandTest)

} // namespace test_moved_by_hand

#include "test_moved_by_hand.moc"
