// What a step on a felt surface looks at, and what it knows already (core/proxy/felt_planes.h).

#include <QTest>

#include "core/proxy/felt_planes.h"
#include "tests/core/proxy/felt_rig.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_felt_passes {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kRadius = 1e-3; // of the proxy
constexpr double kBall = 0.03, kDepth = 3e-3;
constexpr double kFelt = 1e-4 * kRadius; // what a step may leave to be wished

/// A ball that feels round, with grain on it.
std::shared_ptr<const World> grainyBall() {
    Scene scene = sceneOf(roundBall(kBall, 4), frictionless(), kRadius);
    Surface& surface = scene.objects[0].surfaces[0];
    surface.shading.on = true;
    surface.layers.resize(1);
    surface.layers[0].pattern.size = 5e-3;
    surface.layers[0].strength = 5e-5;
    return compile(scene).value();
}

Vec3 along(double s) {
    return (kBall - kDepth) * Vec3(std::sin(s), 0.3, std::cos(s)).normalized();
}

/// In the middle of a stroke, the finger already where the next step has it.
struct Stroke {
    Hand hand{grainyBall()};
    Vec3 finger = along(0.0255);
    StepMotions movers;

    Stroke() {
        hand.to(1.3 * kBall * along(0).normalized());
        hand.go(along(0), 0.1);
        for (int i = 1; i <= 50; ++i)
            hand.to(along(5e-4 * i));
    }
    FeltContacts contactsOf(ProxyState& state) const {
        return {hand.world().obstacles,
                movers,
                {state.contacts.data(), std::size_t(state.contactCount)},
                kRadius,
                finger,
                0.2e-3};
    }
};

} // namespace

class FeltPassesTest : public QObject {
    Q_OBJECT

private slots:
    void knowsWhereItLookedLast();
    void knowsNothingOfOtherContacts();
    void knowsNothingBesideAFace();
    void aStepEndsWhereNothingIsWished();
};

// Where the proxy goes to where a slide was seen to end, everything is as if it was found there anew.
void FeltPassesTest::knowsWhereItLookedLast() {
    const Stroke stroke;
    ProxyState state = stroke.hand.state.proxy;
    QCOMPARE(state.contactCount, 1);
    FeltPasses passes;
    const Vec3 wish = passes.update(state, stroke.contactsOf(state)).x;
    QCOMPARE_GT(wish.norm(), 1e-6);
    const double reach = passes.reach(state, stroke.contactsOf(state), Vec3::Zero(), wish, {}, 0, false);
    Vec3 motion = reach * wish;
    QVERIFY(passes.comeToRest(stroke.contactsOf(state), state.position, motion, kRadius));
    state.position += reach * wish;
    ProxyState anew = state;
    const NearestPoint known = passes.update(state, stroke.contactsOf(state));
    const NearestPoint found = updateFelt(anew, stroke.contactsOf(anew));
    COMPARE_NEAR(known.x, found.x, 1e-15, "m");
    COMPARE_NEAR(state.contacts[0].lambda, anew.contacts[0].lambda, 1e-15, "m");
    QCOMPARE(state.feltCount, anew.feltCount);
    COMPARE_NEAR(state.felt[0].normal, anew.felt[0].normal, 1e-12, "");
}

// A face that was met meanwhile is looked at, although the proxy stands where it was looked last.
void FeltPassesTest::knowsNothingOfOtherContacts() {
    const Stroke stroke;
    ProxyState state = stroke.hand.state.proxy;
    FeltPasses passes;
    passes.update(state, stroke.contactsOf(state));
    const Contact touched = state.contacts[0];
    state.contacts[0].triangle = touched.triangle + 1;
    locate(state.contacts[0], stroke.hand.world().obstacles, stroke.movers, kRadius, state.position);
    ProxyState anew = state;
    Vec3 motion = Vec3::Zero();
    QVERIFY(!passes.comeToRest(stroke.contactsOf(state), state.position, motion, kRadius));
    QVERIFY(!passes.settleAsLooked(state, stroke.contactsOf(state)));
    const NearestPoint known = passes.update(state, stroke.contactsOf(state));
    const NearestPoint found = updateFelt(anew, stroke.contactsOf(anew));
    COMPARE_NEAR(known.x, found.x, 1e-15, "m");
    QCOMPARE(state.felt[0].triangle, touched.triangle + 1);
}

// Ahead a face counts as going on beyond its edge; once the proxy is there, what it touches is the edge.
void FeltPassesTest::knowsNothingBesideAFace() {
    const Stroke stroke;
    ProxyState state = stroke.hand.state.proxy;
    FeltPasses passes;
    const Vec3 wish = passes.update(state, stroke.contactsOf(state)).x;
    const Vec3 far = 5e-3 * wish.normalized(); // a facet is 2 mm wide
    const double reach = passes.reach(state, stroke.contactsOf(state), Vec3::Zero(), far, {}, 1, false);
    COMPARE_NEAR(reach, 1.0, 1e-15, "");
    Vec3 motion = far;
    QVERIFY(!passes.comeToRest(stroke.contactsOf(state), state.position, motion, 1));
    state.position += far;
    ProxyState anew = state;
    const NearestPoint known = passes.update(state, stroke.contactsOf(state));
    const NearestPoint found = updateFelt(anew, stroke.contactsOf(anew));
    COMPARE_NEAR(known.x, found.x, 1e-15, "m");
}

// A step goes to where the finger is held along what is felt there, and needs no round to say so.
void FeltPassesTest::aStepEndsWhereNothingIsWished() {
    Stroke stroke;
    double most = 0, rounds = 0, sum = 0;
    constexpr int kSteps = 1000;
    for (int i = 1; i <= kSteps; ++i) {
        stroke.finger = along(0.025 + 5e-4 * i);
        rounds += stroke.hand.to(stroke.finger).report.rounds;
        ProxyState copy = stroke.hand.state.proxy;
        FeltContacts on = stroke.contactsOf(copy);
        const double way =
            std::min(copy.speed, (along(5e-4) - along(0)).norm() / kMillisecond) * kMillisecond;
        on.smallestFeature = std::max(kStepsToAFeature * way, kFinestFeature * kRadius);
        const double left = updateFelt(copy, on).x.norm();
        most = std::max(most, left);
        sum += left;
    }
    qInfo("%.3g rounds, %.3g nm left in the mean, %.3g at most", rounds / kSteps, 1e9 * sum / kSteps,
          1e9 * most);
    QCOMPARE_LT(most, 3 * kFelt);
    QCOMPARE_LT(sum / kSteps, 0.05 * kFelt);
    QCOMPARE_LT(rounds / kSteps, 2.5);
}

TACTUM_TEST(FeltPassesTest)

} // namespace test_felt_passes

#include "test_felt_passes.moc"
