// The haptic step as a whole: the force of equation 24, bad input, and the model that the servo renders.

#include <limits>

#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/test_program.h"

namespace test_haptic_step {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kRadius = 1e-3;

template <class T> bool sameBits(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof(T)) == 0;
}

bool sameState(const SimState& a, const SimState& b) {
    return sameBits(a.proxy.position, b.proxy.position) && sameBits(a.proxy.finger, b.proxy.finger) &&
           a.proxy.speed == b.proxy.speed && a.proxy.stride == b.proxy.stride &&
           a.proxy.stillFor == b.proxy.stillFor && a.proxy.slidingOn == b.proxy.slidingOn &&
           a.proxy.contactCount == b.proxy.contactCount && sameBits(a.model.proxy, b.model.proxy) &&
           a.model.planes == b.model.planes && a.shapeRevision == b.shapeRevision &&
           std::equal(a.proxy.contacts.begin(), a.proxy.contacts.begin() + a.proxy.contactCount,
                      b.proxy.contacts.begin(), [](const Contact& x, const Contact& y) {
                          return x.triangle == y.triangle && x.slipping == y.slipping && x.gap == y.gap &&
                                 x.lambda == y.lambda && x.normal == y.normal;
                      });
}

Hand onSheet(const Material& material) {
    Hand hand(worldOf(sheet(0.05), material, kRadius));
    hand.to({0, 0, 0.003});
    hand.go({0, 0, 0}, 0.05);
    return hand;
}

} // namespace

class HapticStepTest : public QObject {
    Q_OBJECT

private slots:
    void forceIsStiffnessTimesStretch();
    void dampingOnlyPushes();
    void contactForcesAddUp();
    void freeFingerFeelsNothing();
    void badInputChangesNothing();
    void badInputAfterASwapOfWorlds();
    void startsOnTheFinger();
    void materialEditKeepsTheContact();
    void modelGivesTheForceOfTheStep_data();
    void modelGivesTheForceOfTheStep();
    void modelFollowsTheFingerAlongThePlane();
    void modelRubsOnAllPlanesOfAFloor();
    void mixesMaterialsByTheirPush();
    void aRehearsalChangesNothing();
};

void HapticStepTest::forceIsStiffnessTimesStretch() {
    for (double stiffness : {100.0, 800.0, 3000.0}) {
        Material material = frictionless();
        material.stiffness = stiffness;
        const Hand hand = onSheet(material);
        COMPARE_NEAR(hand.output().force, Vec3(0, 0, stiffness * kRadius), 1e-9 * stiffness, "N");
        QCOMPARE(hand.output().contacts, 1);
        COMPARE_NEAR(hand.output().contact[0].normal, Vec3::UnitZ(), 1e-12, "");
        QCOMPARE_LT(hand.output().contact[0].point.norm(), 1e-12);
        COMPARE_NEAR(hand.output().contact[0].normalForce, stiffness * kRadius, 1e-9 * stiffness, "N");
    }
}

void HapticStepTest::dampingOnlyPushes() {
    Material material = frictionless();
    material.damping = 10;
    const Hand hand = onSheet(material);
    for (const double speed : {-0.2, 0.0, 0.2}) {
        SimState state = hand.state;
        const HapticOutput output =
            hapticStep(hand.world(), state, {Vec3::Zero(), {0, 0, speed}}, kMillisecond);
        const double expected = 800 * kRadius + 10 * std::max(0.0, -speed);
        COMPARE_NEAR(output.force.z(), expected, 1e-6, "N");
        QCOMPARE_LT(output.force.head<2>().norm(), 1e-9);
    }
}

// Equation (19): the forces on the planes are those of the spring.
void HapticStepTest::contactForcesAddUp() {
    Hand hand(worldOf(pit(evenRays(3, 0.6), 0.1), frictionless(), kRadius));
    hand.to({0, 0, 0.01});
    hand.go({0.0003, -0.0002, -0.003}, 0.05);
    hand.to(hand.finger());
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < hand.output().contacts; ++i)
        sum += hand.output().contact[i].normalForce * hand.output().contact[i].normal;
    QCOMPARE(hand.output().contacts, 3);
    COMPARE_NEAR(sum, hand.output().force, 1e-6, "N");
}

void HapticStepTest::freeFingerFeelsNothing() {
    Hand hand(worldOf(sheet(0.05), frictionless(), kRadius));
    hand.to({0, 0, 0.02});
    hand.go({0.01, 0.01, 0.005}, 0.3, [](const Hand& h) {
        QCOMPARE(h.output().force, Vec3(Vec3::Zero()));
        QCOMPARE(h.output().proxy, h.finger());
        QCOMPARE(contactModelForce(h.state.model, h.finger() + Vec3(1e-3, 0, 0), Vec3::Zero()),
                 Vec3(Vec3::Zero()));
    });
}

void HapticStepTest::badInputChangesNothing() {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                     inf = std::numeric_limits<double>::infinity();
    Hand hand = onSheet(rough(0.5, 0.4));
    hand.go({0.003, 0, 0}, 0.05);
    const Vec3 here = hand.finger();
    for (const HapticInput& input :
         {HapticInput{{nan, 0, 0}, Vec3::Zero()}, HapticInput{{0, inf, 0}, Vec3::Zero()},
          HapticInput{here, {0, 0, nan}}, HapticInput{{0, 0, -inf}, {nan, nan, nan}}}) {
        const SimState before = hand.state;
        const HapticOutput output = hapticStep(hand.world(), hand.state, input, kMillisecond);
        QCOMPARE(output.force, Vec3(Vec3::Zero()));
        QVERIFY(sameState(hand.state, before));
    }
    QCOMPARE_GT(hand.to(here).force.norm(), 0.1);
}

// The contacts belong to the world before: they name bodies that the new one does not have.
void HapticStepTest::badInputAfterASwapOfWorlds() {
    Hand hand = onSheet(frictionless());
    const auto nothing = compile(Scene{}, &hand.world()).value();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const HapticOutput output =
        hapticStep(*nothing, hand.state, {{nan, nan, nan}, Vec3::Zero()}, kMillisecond);
    QCOMPARE(output.contacts, 0);
    QCOMPARE(output.force, Vec3(Vec3::Zero()));
}

void HapticStepTest::startsOnTheFinger() {
    Hand hand(worldOf(sheet(0.05), frictionless(), kRadius));
    QCOMPARE(hand.to({0, 0, -0.02}).proxy, Vec3(0, 0, -0.02));
    QCOMPARE(hand.output().force, Vec3(Vec3::Zero()));
}

void HapticStepTest::materialEditKeepsTheContact() {
    Scene scene = sceneOf(sheet(0.05), frictionless(), kRadius);
    Hand hand(compile(scene).value());
    const std::shared_ptr<const World> first = compile(scene).value();
    hand.take(first);
    hand.to({0, 0, 0.003});
    hand.go({0, 0, 0}, 0.05);
    scene.objects[0].surfaces[0].material.stiffness = 1600;
    hand.take(compile(scene, first.get()).value());
    const Vec3 held = hand.output().proxy;
    hand.to(hand.finger());
    QCOMPARE(hand.output().proxy, held);
    COMPARE_NEAR(hand.output().force.z(), 1600 * kRadius, 1e-6, "N");
    // So does a pose that leaves the surface where the proxy is.
    const auto second = compile(scene, first.get()).value();
    scene.objects[0].pose.translation.x() = 0.01;
    hand.take(compile(scene, second.get()).value());
    COMPARE_NEAR(hand.to(hand.finger()).proxy, held, 2 * kSkin * kRadius, "m");
    COMPARE_NEAR(hand.output().force.z(), 1600 * kRadius, 1e-4, "N");
}

void HapticStepTest::modelGivesTheForceOfTheStep_data() {
    QTest::addColumn<double>("mu");
    QTest::addColumn<double>("viscosity");
    QTest::newRow("frictionless") << 0.0 << 0.0;
    QTest::newRow("friction") << 0.4 << 0.0;
    QTest::newRow("viscous friction") << 0.4 << 1.0;
}

void HapticStepTest::modelGivesTheForceOfTheStep() {
    QFETCH(double, mu);
    QFETCH(double, viscosity);
    Rng rng(91);
    for (const Soup& soup :
         {ball(0.01, 2), eggCrate(0.02, 20, 0.002, 0.01), pit(evenRays(6, 0.6), 0.03), sheet(0.02, 20)}) {
        Hand hand(worldOf(soup, rough(mu, 0.8 * mu, viscosity), kRadius));
        hand.to({0, 0, 0.02});
        for (int i = 0; i < 40; ++i)
            hand.go(0.009 * Vec3(direction(rng).cwiseProduct(Vec3(1, 1, 0.8))), kHandSpeed,
                    [](const Hand& h) {
                        if (h.output().report.boundHit) return;
                        const Vec3 force = contactModelForce(h.state.model, h.finger(), Vec3::Zero());
                        const Vec3 step = h.state.model.stiffness * (h.output().proxy - h.finger());
                        QVERIFY2((force - step).norm() <= 1e-9 + 1e-9 * step.norm(),
                                 qPrintable(QString("differs by %1 N").arg((force - step).norm())));
                    });
    }
}

// Between proxy updates the servo's finger slides on the plane without drag and is pushed by its depth.
void HapticStepTest::modelFollowsTheFingerAlongThePlane() {
    const Hand hand = onSheet(frictionless());
    const Vec3 force = contactModelForce(hand.state.model, {0.01, -0.02, -0.001}, Vec3::Zero());
    COMPARE_NEAR(force, Vec3(0, 0, 800 * 0.002), 1e-6, "N");
    QCOMPARE(contactModelForce(hand.state.model, {0, 0, 0.002}, Vec3::Zero()).norm(), 0.0);
    const Hand held = onSheet(rough(0.5, 0.5));
    const Vec3 within = contactModelForce(held.state.model, {0.0004, 0, 0}, Vec3::Zero());
    COMPARE_NEAR(within, 800 * Vec3(-0.0004, 0, kRadius), 1e-6, "N");
    const Vec3 beyond = contactModelForce(held.state.model, {0.002, 0, 0}, Vec3::Zero());
    COMPARE_NEAR(beyond, 800 * Vec3(-0.0005, 0, kRadius), 1e-5, "N");
}

// Along a shallow groove, faces leaning by a to either side: each carries d / (2 cos a) and bears on the
// other by cos 2a, so that the finger drags the proxy by all but mu d cos a.
void HapticStepTest::modelRubsOnAllPlanesOfAFloor() {
    constexpr double kMu = 0.5, kDepth = 1e-3, kAlong = 2e-3;
    for (const double lean : {1e-6, 1e-3, 0.1, 0.5}) {
        LocalContactModel model{.planes = 2, .stiffness = 800, .valid = true};
        for (int i = 0; i < 2; ++i) {
            model.plane[std::size_t(i)].normal = {(i ? -1 : 1) * std::sin(lean), 0, std::cos(lean)};
            model.friction[std::size_t(i)].coefficient = kMu;
        }
        const Anchor anchor = anchorOf(model, {0, kAlong, -kDepth});
        const Vec3 expected(0, kAlong - kMu * kDepth * std::cos(lean), 0);
        QVERIFY2((anchor.position - expected).norm() < 1e-9, qPrintable(QString::number(lean)));
    }
}

void HapticStepTest::mixesMaterialsByTheirPush() {
    auto two = std::make_shared<TriangleSoup>(*wedge(std::numbers::pi / 2, 0.1));
    two->surfaceOf = {0, 0, 1, 1};
    Scene scene = sceneOf(two, frictionless(), kRadius);
    scene.objects[0].surfaces.resize(2);
    scene.objects[0].surfaces[0].material.stiffness = 500;
    scene.objects[0].surfaces[1].material.stiffness = 1500;
    Hand hand(compile(scene).value());
    const double bottom = kRadius * std::numbers::sqrt2;
    hand.to({0, 0, bottom + 0.003});
    hand.go({0, 0, bottom - 0.001}, 0.05);
    hand.to(hand.finger());
    QCOMPARE(hand.output().contacts, 2);
    COMPARE_NEAR(hand.output().force.z(), 1000 * 0.001, 1e-5, "N");
    QCOMPARE_NE(hand.output().contact[0].surface, hand.output().contact[1].surface);
}

// Over a rough ground with friction: rehearsed before each step, with the finger where it will be and where
// it will not, the steps have the bits that they have without.
void HapticStepTest::aRehearsalChangesNothing() {
    const auto world = worldOf(eggCrate(0.05, 60, 1e-3, 8e-3), {800, 1, 0.3, 0.2, 0}, kRadius);
    SimState plain, rehearsed;
    HandState copy;
    Vec3 before(-0.02, 0, 0.01);
    int touching = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 finger(-0.02 + 2e-5 * i, 0.01 * std::sin(0.01 * i), 0.002 * std::cos(0.02 * i));
        const HapticInput input{finger, (finger - before) / kMillisecond};
        rehearse(*world, rehearsed, rehearsed.time, input, kMillisecond, copy);
        rehearse(*world, rehearsed, rehearsed.time, {.finger = Vec3(0, 0, -0.01 * (i % 3))}, kMillisecond,
                 copy);
        const HapticOutput a = hapticStep(*world, plain, input, kMillisecond);
        const HapticOutput b = hapticStep(*world, rehearsed, input, kMillisecond);
        QVERIFY2(sameState(plain, rehearsed) && sameBits(a.force, b.force), qPrintable(QString::number(i)));
        touching += a.contacts > 0;
        before = finger;
    }
    QCOMPARE_GT(touching, 1000);
}

TACTUM_TEST(HapticStepTest)

} // namespace test_haptic_step

#include "test_haptic_step.moc"
