// Several hands in one World: what they hold between them, and that none of them is another one's.
//
// What would show that a test here is wrong: each expected number is a closed form of a box between two
// springs (Coulomb's cone on two sides, the balance of forces, the fall under what friction leaves of the
// weight); the data rows take other masses, springs and grips, at which the numbers are others.

#include <cmath>
#include <cstring>
#include <limits>

#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/support/two_hands.h"

namespace test_two_hands {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kMass = 0.05, kWeight = kMass * kGravity, kStiffness = 800, kDepth = 2e-3;

Material grip(double friction, double stiffness = kStiffness, double damping = 0) {
    Material feel = rough(friction, friction);
    feel.stiffness = stiffness;
    feel.damping = damping;
    return feel;
}

std::shared_ptr<const World> boxWorld(double friction, double mass = kMass, double stiffness = kStiffness) {
    return compile(boxOnFloor(mass, grip(friction, stiffness))).value();
}

bool sameBits(const Vec3& a, const Vec3& b) {
    return std::memcmp(a.data(), b.data(), sizeof(double) * 3) == 0;
}

/// A finger that presses a box on the floor aside, slides on it and lets go.
Vec3 strokeAt(int step) {
    const double t = 1e-3 * step;
    return {-kBoxHalf - kFingertip + 2e-3 * std::sin(9 * t), 4e-3 * std::sin(5 * t), 3e-3 * std::sin(3 * t)};
}

} // namespace

class TwoHandsTest : public QObject {
    Q_OBJECT

private slots:
    void aHandFeelsTheSameBitsWhereAnotherTouchesNothing();
    void theyHoldABoxForAMinute_data();
    void theyHoldABoxForAMinute();
    void aBoxSlipsBelowHalfItsWeightOverTheGrip_data();
    void aBoxSlipsBelowHalfItsWeightOverTheGrip();
    void whatSlipsFallsUnderWhatFrictionLeavesOfItsWeight();
    void lightBodiesAreCalmBetweenFour_data();
    void lightBodiesAreCalmBetweenFour();
    void whatOneHandDoesNotGetTheOtherPushesAway();
    void aHandThatIsNowhereIsLeftOut();
    void allBeginAnewTogether();
};

// Alone, by the call for one, and beside a second hand in the air.
void TwoHandsTest::aHandFeelsTheSameBitsWhereAnotherTouchesNothing() {
    const auto world = boxWorld(0.4), again = boxWorld(0.4);
    SimState alone;
    TwoHands both(again);
    int touching = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vec3 finger = strokeAt(i);
        const Vec3 velocity = i ? Vec3((finger - strokeAt(i - 1)) / kMillisecond) : Vec3::Zero();
        const HapticOutput one = hapticStep(*world, alone, {finger, velocity}, kMillisecond);
        both.to({finger, Vec3(0.3, 0.1 * std::sin(0.01 * i), 0)}, {});
        touching += one.contacts > 0;
        QVERIFY2(sameBits(one.force, both.output(0).force), qPrintable(QString::number(i)));
        QVERIFY2(sameBits(one.proxy, both.output(0).proxy), qPrintable(QString::number(i)));
    }
    QCOMPARE_GT(touching, 500);
    QCOMPARE_GT(both.box().norm(), 1e-4);
    QCOMPARE(std::memcmp(alone.bodies.q.data(), both.shared.bodies.q.data(), 13 * sizeof(double)), 0);
}

void TwoHandsTest::theyHoldABoxForAMinute_data() {
    QTest::addColumn<double>("mass");
    QTest::addColumn<double>("stiffness");
    QTest::addColumn<double>("depth");
    QTest::newRow("50 g") << kMass << kStiffness << kDepth;
    QTest::newRow("200 g, stiff") << 0.2 << 2000.0 << 2e-3;
    QTest::newRow("5 g, soft") << 5e-3 << 200.0 << 1e-3;
}

// Each side bears half of the weight; along the grip both springs are as long as they were.
void TwoHandsTest::theyHoldABoxForAMinute() {
    QFETCH(double, mass);
    QFETCH(double, stiffness);
    QFETCH(double, depth);
    const double weight = mass * kGravity, lift = 0.03;
    TwoHands hands(boxWorld(0.9, mass, stiffness));
    hands.go(-1e-3, 0, 10);
    hands.go(depth, 0, 200);
    hands.go(depth, lift, 600);
    hands.go(depth, lift, 1000);
    const double sag = weight / 2 / stiffness; // of each spring across the grip
    COMPARE_NEAR(hands.box().y(), lift - sag, 0.2 * sag + 1e-5, "m");
    const Vec3 begin = hands.box();
    Vec3 mean = Vec3::Zero();
    double farthest = 0;
    const int steps = 60'000;
    hands.go(depth, lift, steps, [&] {
        mean += hands.forces() / steps;
        farthest = std::max(farthest, (hands.box() - begin).norm());
    });
    COMPARE_NEAR(mean, Vec3(0, -weight, 0), 1e-3 * weight, "N");
    COMPARE_NEAR(hands.forces(), Vec3(0, -weight, 0), 0.01 * weight, "N");
    COMPARE_NEAR(hands.output(0).force.y(), -weight / 2, 0.01 * weight, "N");
    COMPARE_NEAR(hands.output(0).force.x(), -stiffness * depth, 1e-3 * stiffness * depth, "N");
    COMPARE_NEAR(hands.output(1).force.x(), stiffness * depth, 1e-3 * stiffness * depth, "N");
    QCOMPARE_LT(farthest, 2e-6);
}

void TwoHandsTest::aBoxSlipsBelowHalfItsWeightOverTheGrip_data() {
    theyHoldABoxForAMinute_data();
}

// The slider goes down while they hold it.
void TwoHandsTest::aBoxSlipsBelowHalfItsWeightOverTheGrip() {
    QFETCH(double, mass);
    QFETCH(double, stiffness);
    QFETCH(double, depth);
    const double critical = mass * kGravity / 2 / (stiffness * depth), lift = 0.03;
    Scene scene = boxOnFloor(mass, grip(0.9, stiffness));
    TwoHands hands(compile(scene).value());
    hands.go(-1e-3, 0, 10);
    hands.go(depth, 0, 200);
    hands.go(depth, lift, 600);
    double friction = 1.2 * critical, held = 0;
    for (; friction > 0.5 * critical; friction -= 0.01 * critical) {
        scene.objects[0].surfaces[0].material = grip(friction, stiffness);
        hands.take(compile(scene, &hands.world()).value());
        hands.go(depth, lift, 300);
        if (hands.boxVelocity().norm() > 1e-3) break;
        held = friction;
    }
    COMPARE_NEAR(held, critical, 0.03 * critical, "");
    hands.go(depth, lift, 600);
    QCOMPARE_LT(hands.box().y(), 1e-4); // on the floor again
}

void TwoHandsTest::whatSlipsFallsUnderWhatFrictionLeavesOfItsWeight() {
    const double friction = 0.5 * kWeight / 2 / (kStiffness * kDepth);
    Scene scene = boxOnFloor(kMass, grip(0.9));
    TwoHands hands(compile(scene).value());
    hands.go(-1e-3, 0, 10);
    hands.go(kDepth, 0, 200);
    hands.go(kDepth, 0.05, 1000);
    scene.objects[0].surfaces[0].material = grip(friction);
    hands.take(compile(scene, &hands.world()).value());
    hands.go(kDepth, 0.05, 20); // it lets go
    const double before = hands.boxVelocity().y();
    const int steps = 50;
    hands.go(kDepth, 0.05, steps);
    const double fell = before - hands.boxVelocity().y(), time = steps * kMillisecond;
    COMPARE_NEAR(fell, kGravity / 2 * time, 0.02 * kGravity * time, "m/s");
}

void TwoHandsTest::lightBodiesAreCalmBetweenFour_data() {
    QTest::addColumn<double>("mass");
    QTest::addColumn<double>("delay");
    for (const double mass : {0.02, 1e-3, 1e-5})
        for (const double delay : {0.0, 1.5e-3})
            QTest::addRow("%g kg, %g s", mass, delay) << mass << delay;
}

// As many hands as there can be, from four sides. Along each axis two press and two stick: four springs of 5
// kN/m on one body.
void TwoHandsTest::lightBodiesAreCalmBetweenFour() {
    QFETCH(double, mass);
    QFETCH(double, delay);
    const double stiffness = 5000, press = 1e-3;
    const auto world = boxWorld(0.9, mass, stiffness);
    WorldState shared;
    std::array<HandState, kMaxHands> states;
    std::vector<HandStep> steps;
    for (HandState& state : states)
        steps.push_back({state, {}});
    const std::array<Vec3, 4> out{Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitZ(), -Vec3::UnitZ()};
    double fastest = 0;
    for (int i = 0; i < 3000; ++i) {
        const double depth = std::min(5e-6 * i, 2 * press) - press;
        for (std::size_t k = 0; k < steps.size(); ++k)
            steps[k].input = {.finger = (kBoxHalf + kFingertip - depth) * out[k],
                              .coupling = {.delay = delay}};
        hapticStep(*world, shared, steps, kMillisecond);
        if (i > 2000)
            fastest =
                std::max(fastest, Vec3(shared.bodies.v[0], shared.bodies.v[1], shared.bodies.v[2]).norm());
    }
    for (std::size_t k = 0; k < steps.size(); ++k)
        COMPARE_NEAR(steps[k].output.force, Vec3(stiffness * press * out[k]), 0.01, "N");
    QCOMPARE_LT(fastest, 1e-4);
}

// The left hand's forces are off: what only the right one feels is what pushes the box.
void TwoHandsTest::whatOneHandDoesNotGetTheOtherPushesAway() {
    const double mass = 2;
    Scene scene = boxOnFloor(mass, grip(0));
    scene.mechanics.colliders.clear();
    scene.mechanics.gravity = Vec3::Zero();
    TwoHands hands(compile(scene).value());
    const auto at = [](double depth) {
        return std::array<Vec3, 2>{Vec3(-kBoxHalf - kFingertip + depth, 0, 0),
                                   Vec3(kBoxHalf + kFingertip - depth, 0, 0)};
    };
    const std::array<Coupling, 2> couplings{Coupling{.force = 0}, Coupling{.force = 1}};
    hands.to(at(-1e-3), couplings);
    const int steps = 20;
    for (int i = 0; i <= steps; ++i)
        hands.to(at(kDepth), couplings); // 1.6 N, of which the right hand gets 1 N
    const double expected = -1 / mass * steps * kMillisecond;
    COMPARE_NEAR(hands.boxVelocity().x(), expected, 0.03 * std::abs(expected), "m/s");
}

void TwoHandsTest::aHandThatIsNowhereIsLeftOut() {
    const auto world = boxWorld(0.4), again = boxWorld(0.4);
    SimState alone;
    TwoHands both(again);
    const Vec3 nowhere = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    for (int i = 0; i < 500; ++i) {
        const Vec3 finger = strokeAt(i);
        const Vec3 velocity = i ? Vec3((finger - strokeAt(i - 1)) / kMillisecond) : Vec3::Zero();
        const HapticOutput one = hapticStep(*world, alone, {finger, velocity}, kMillisecond);
        both.to({finger, nowhere}, {});
        QVERIFY(sameBits(one.force, both.output(0).force));
        QCOMPARE(both.output(1).force, Vec3(Vec3::Zero()));
    }
    const double time = both.shared.time;
    both.to({nowhere, nowhere}, {});
    QCOMPARE(both.shared.time, time);
}

// Whoever comes first in the list.
void TwoHandsTest::allBeginAnewTogether() {
    const auto felt = [](bool turned) {
        TwoHands hands(boxWorld(0.9));
        hands.go(-1e-3, 0, 10);
        hands.go(kDepth, 0, 200);
        hands.go(kDepth, 0.01, 600); // the fingers are still beside where the box was
        const std::size_t first = turned ? 1 : 0, second = 1 - first;
        const auto stepOf = [&](std::size_t which) {
            HandState& state = hands.hands[which];
            return HandStep{state, {.finger = state.proxy.finger}};
        };
        std::array steps{stepOf(first), stepOf(second)};
        hapticStep(hands.world(), hands.shared, steps, kMillisecond, {.begin = true});
        return std::pair{hands.box(), std::array{steps[first].output.force, steps[second].output.force}};
    };
    const auto [box, forces] = felt(false);
    const auto [boxTurned, forcesTurned] = felt(true);
    COMPARE_NEAR(box, Vec3(0, 0, 0), 1e-4, "m");
    for (const std::size_t hand : {0, 1})
        QVERIFY(sameBits(forces[hand], forcesTurned[hand]));
}

TACTUM_TEST(TwoHandsTest)

} // namespace test_two_hands

#include "test_two_hands.moc"
