// Friction through whole haptic steps, on planes at a fixed depth: section 4 in newtons.

#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/test_program.h"

namespace test_friction_step {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kRadius = 1e-3;
constexpr double kDepth = 1e-3; // of the finger below where the proxy rests: 0.8 N at 800 N/m
constexpr double kPart = 0.005; // every law holds to half a percent
constexpr double kFine = 1e-3;  // m/s: a ramp of 1 um a step

bool about(double value, double expected) {
    return std::abs(value - expected) <= kPart * std::abs(expected);
}

double tangential(const Hand& hand) {
    return std::hypot(hand.output().force.x(), hand.output().force.y());
}
double normalForce(const Hand& hand) {
    return hand.output().force.z();
}
bool slips(const Hand& hand) {
    return hand.output().contacts > 0 && hand.output().contact[0].slipping;
}

// A finger pressed straight down to the depth.
Hand pressed(Soup soup, const Material& material, const Vec3& at = Vec3::Zero(), double dt = kMillisecond) {
    Hand hand(worldOf(std::move(soup), material, kRadius), dt);
    hand.to(at + Vec3(0, 0, 0.003));
    hand.go(at + Vec3(0, 0, kRadius - kDepth), 0.05);
    return hand;
}

// Ramps the finger sideways until the contact slips; returns the largest tangential force over the normal
// one. `speed` in m/s.
double breakAway(Hand& hand, const Vec3& toward, double speed = kFine) {
    double largest = 0;
    hand.go(hand.finger() + 0.004 * toward, speed,
            [&](const Hand& h) { largest = std::max(largest, tangential(h) / normalForce(h)); });
    return largest;
}

} // namespace

class FrictionStepTest : public QObject {
    Q_OBJECT

private slots:
    void breaksAwayAtStaticFriction();
    void slidesAtDynamicFrictionAndViscosity_data();
    void slidesAtDynamicFrictionAndViscosity();
    void reversalSwingsTwice();
    void sticksAgainAtRest();
    void sticksOnTheWayBack();
    void aFingerInStepsSlidesOn();
    void slopeHoldsUpToItsAngle();
    void closedPathsGiveNoEnergy();
    void steadySlideDoesNotBuzz_data();
    void steadySlideDoesNotBuzz();
    void frictionlessSurfaceHasNoTangentialForce();
    void anyStickingPlaneHolds();
    void aSeamRubsAsTheFloorBesideIt_data();
    void aSeamRubsAsTheFloorBesideIt();
};

void FrictionStepTest::aSeamRubsAsTheFloorBesideIt_data() {
    QTest::addColumn<double>("gap");
    for (const double gap : {0.0, 1e-7, 1e-5, 1e-4})
        QTest::addRow("%g m wide", gap) << gap;
}

// Two tiles share the load; the finger slides along the seam between them.
void FrictionStepTest::aSeamRubsAsTheFloorBesideIt() {
    QFETCH(double, gap);
    constexpr double kHalf = 0.05;
    SoupBuilder tiles;
    for (const double side : {-1.0, 1.0}) {
        const double near = 0.5 * side * gap, far = side * kHalf;
        tiles.quad({near, -kHalf, 0}, {far, -kHalf, 0}, {far, kHalf, 0}, {near, kHalf, 0});
    }
    Hand hand = pressed(tiles.build(), rough(0.6, 0.5));
    hand.go({0, 0.02, hand.finger().z()}, 0.02);
    QVERIFY(slips(hand));
    COMPARE_NEAR(tangential(hand) / normalForce(hand), 0.5, kPart * 0.5, "");
}

void FrictionStepTest::breaksAwayAtStaticFriction() {
    for (double mu : {0.1, 0.3, 0.7, 1.5}) {
        Hand hand = pressed(sheet(0.05), rough(mu, 0.5 * mu));
        const Vec3 held = hand.output().proxy;
        hand.go(hand.finger() + Vec3((1 - kPart) * mu * kDepth, 0, 0), kFine);
        QCOMPARE(hand.output().proxy, held); // not a bit before the cone
        QVERIFY(!slips(hand));
        Hand again = pressed(sheet(0.05), rough(mu, 0.5 * mu));
        const double peak =
            breakAway(again, Vec3(0.6, 0.8, 0), mu * kFine); // a thousandth of the cone a step
        COMPARE_NEAR(peak, mu, kPart * mu, "");
        QVERIFY(slips(again));
        COMPARE_NEAR(tangential(again) / normalForce(again), 0.5 * mu, kPart * 0.5 * mu, "");
    }
}

void FrictionStepTest::slidesAtDynamicFrictionAndViscosity_data() {
    QTest::addColumn<double>("viscosity");
    QTest::addColumn<double>("dt");
    for (double viscosity : {0.0, 1e-4, 0.5, 2.0, 10.0})
        for (double dt : {2.5e-4, 1e-3, 5e-3})
            QTest::addRow("b = %g N s/m, dt = %g ms", viscosity, 1e3 * dt) << viscosity << dt;
}

void FrictionStepTest::slidesAtDynamicFrictionAndViscosity() {
    QFETCH(double, viscosity);
    QFETCH(double, dt);
    const Material material = rough(0.5, 0.3, viscosity);
    for (double speed : {0.02, 0.1, 0.3}) {
        Hand hand = pressed(sheet(0.3), material, {-0.15, 0, 0}, dt);
        hand.go(hand.finger() + Vec3(0.25, 0, 0), speed);
        const double pressing = material.stiffness * kDepth;
        COMPARE_NEAR(normalForce(hand), pressing, kPart * pressing, "N");
        const double expected = material.dynamicFriction * pressing + viscosity * speed;
        COMPARE_NEAR(tangential(hand), expected, kPart * expected, "N");
        QCOMPARE_LT(hand.output().force.x(), 0);
    }
}

// From sliding one way to breaking away the other way the finger travels twice the cone's width.
void FrictionStepTest::reversalSwingsTwice() {
    constexpr double mu = 0.5;
    Hand hand = pressed(sheet(0.05), rough(mu, mu));
    hand.go(hand.finger() + Vec3(0.003, 0, 0), kFine);
    COMPARE_NEAR(-hand.output().force.x() / normalForce(hand), mu, kPart * mu, "");
    const Vec3 turned = hand.finger(), held = hand.output().proxy;
    double swing = 0;
    hand.go(turned - Vec3(0.003, 0, 0), kFine, [&](const Hand& h) {
        if (h.output().proxy == held) swing = turned.x() - h.finger().x();
    });
    COMPARE_NEAR(swing, 2 * mu * kDepth, kPart * 2 * mu * kDepth, "m");
    COMPARE_NEAR(hand.output().force.x() / normalForce(hand), mu, kPart * mu, "");
}

// A slide that comes to rest is held by static friction again, on the same face and the other way round.
void FrictionStepTest::sticksAgainAtRest() {
    Hand hand = pressed(sheet(0.05), rough(0.6, 0.3));
    const auto rest = [&] {
        for (int i = 0; i < 60; ++i)
            hand.to(hand.finger());
    };
    hand.go(hand.finger() + Vec3(0.003, 0, 0), kFine);
    QVERIFY(slips(hand));
    rest();
    QVERIFY(!slips(hand));
    for (double sign : {1.0, -1.0}) {
        const double peak = breakAway(hand, Vec3(sign, 0, 0));
        COMPARE_NEAR(peak, 0.6, kPart * 0.6, "");
        rest();
    }
}

// On the way back it is well inside of the cone, and holds at once.
void FrictionStepTest::sticksOnTheWayBack() {
    constexpr double kFast = 0.1;
    Hand hand = pressed(sheet(0.05), rough(0.6, 0.3));
    hand.go(hand.finger() + Vec3(0.01, 0, 0), kFast);
    QVERIFY(slips(hand));
    double peak = 0; // within one tick's way of where it lets go
    hand.go(hand.finger() - Vec3(0.01, 0, 0), kFast,
            [&](const Hand& h) { peak = std::max(peak, h.output().force.x() / h.output().force.z()); });
    const double oneTick = kFast * kMillisecond / kDepth;
    QCOMPARE_LE(peak, 0.6);
    QCOMPARE_GE(peak, (0.6 - oneTick));
}

// An encoder tells the same place for some ticks and then the next: that is no rest, and what slides slides
// on.
void FrictionStepTest::aFingerInStepsSlidesOn() {
    for (const double count : {1e-6, 10e-6, 50e-6})
        for (const double speed : {0.005, 0.02, 0.1}) {
            Hand hand = pressed(sheet(0.05), rough(0.6, 0.3));
            const Vec3 from = hand.finger();
            double least = 1, most = 0;
            for (double way = 0; way < 0.01; way += speed * kMillisecond) {
                hand.to(from + count * std::round(way / count) * Vec3::UnitX());
                if (way < 0.004) continue; // it has let go
                const double ratio = -hand.output().force.x() / hand.output().force.z();
                least = std::min(least, ratio), most = std::max(most, ratio);
            }
            COMPARE_NEAR(least, 0.3, kPart * 0.3, "");
            COMPARE_NEAR(most, 0.3, kPart * 0.3, "");
        }
}

void FrictionStepTest::slopeHoldsUpToItsAngle() {
    constexpr double mu = 0.4;
    for (double part : {0.5, 0.995, 1.005, 1.5}) {
        const double slope = part * mu; // tan a
        const Vec3 normal = Vec3(-slope, 0, 1).normalized();
        Hand hand(worldOf(heightField(0.05, 4, [&](double x, double) { return slope * x; }), rough(mu, mu),
                          kRadius));
        const Vec3 start = (kRadius + 1e-4) * normal;
        hand.to(start);
        hand.go(start - Vec3(0, 0, 0.003), 0.05);
        const Vec3 first = hand.output().proxy;
        for (int i = 0; i < 200; ++i)
            hand.to(hand.output().proxy - Vec3(0, 0, 0.003)); // a constant force straight down
        const double slid = (hand.output().proxy - first).norm();
        QVERIFY2(part < 1 ? slid == 0 : slid > 1e-4,
                 qPrintable(QString("tan a = %1 mu: slid %2 m").arg(part).arg(slid)));
    }
}

// From untouched to untouched, with random loops in the surface between: work only goes into friction.
void FrictionStepTest::closedPathsGiveNoEnergy() {
    Rng rng(81);
    for (double viscosity : {0.0, 1.0})
        for (int run = 0; run < 20; ++run) {
            Hand hand(
                worldOf(run % 2 ? ball(0.05, 2) : heightField(0.1, 40, [](double, double) { return 0.05; }),
                        rough(0.6, run % 3 ? 0.4 : 0.6, viscosity), kRadius));
            const Vec3 outside(0, 0, 0.06);
            hand.to(outside);
            double given = 0, taken = 0;
            Vec3 before = outside, force = Vec3::Zero();
            auto account = [&](const Hand& h) {
                const double work = 0.5 * (force + h.output().force).dot(h.finger() - before);
                (work > 0 ? given : taken) += work;
                before = h.finger();
                force = h.output().force;
            };
            hand.go({0, 0, 0.0495}, 0.05, account);
            const Vec3 home = hand.finger();
            for (int k = 0; k < 8; ++k)
                hand.go({uniform(rng, -0.006, 0.006), uniform(rng, -0.006, 0.006), home.z()},
                        uniform(rng, 0.01, 0.2), account);
            hand.go(home, 0.1, account);
            hand.go(outside, 0.05, account);
            QCOMPARE(hand.output().force.norm(), 0.0);
            QVERIFY2(given + taken <= 1e-9,
                     qPrintable(QString("run %1 gives %2 J").arg(run).arg(given + taken)));
            QCOMPARE_LT(taken, -1e-5);
        }
}

void FrictionStepTest::steadySlideDoesNotBuzz_data() {
    QTest::addColumn<int>("cells");
    QTest::addColumn<double>("viscosity");
    for (int cells : {1, 10, 100, 300})
        for (double viscosity : {0.0, 1.0})
            QTest::addRow("%d cells, b = %g", cells, viscosity) << cells << viscosity;
}

// A finely meshed plane feels as the plane that it is: never a re-stick, never a change of force.
void FrictionStepTest::steadySlideDoesNotBuzz() {
    QFETCH(int, cells);
    QFETCH(double, viscosity);
    const double speed = 0.1;
    Hand hand = pressed(sheet(0.05, cells), rough(0.6, 0.3, viscosity), {-0.03, -0.0123, 0});
    hand.go(hand.finger() + Vec3(0.01, 0.002, 0), speed); // the break-away is over
    int stuck = 0, rough = 0;
    const double expected = 0.3 * 800 * kDepth + viscosity * speed;
    hand.go(hand.finger() + Vec3(0.05, 0.01, 0), speed, [&](const Hand& h) {
        stuck += !slips(h);
        rough += !about(tangential(h), expected) || !about(normalForce(h), 800 * kDepth);
    });
    QCOMPARE(stuck, 0);
    QCOMPARE(rough, 0);
}

void FrictionStepTest::frictionlessSurfaceHasNoTangentialForce() {
    Hand hand = pressed(sheet(0.05, 50), frictionless(), {-0.03, 0.001, 0});
    hand.go(hand.finger() + Vec3(0.05, 0.01, 0), 0.2, [&](const Hand& h) {
        QCOMPARE_LE(tangential(h), 1e-6 * normalForce(h));
        COMPARE_NEAR(normalForce(h), 800 * kDepth, 1e-6 * 800 * kDepth, "N");
    });
}

// In a right-angled valley both planes carry; along it the finger is held while one of them still sticks.
void FrictionStepTest::anyStickingPlaneHolds() {
    constexpr double mu = 0.5;
    Hand hand(worldOf(wedge(std::numbers::pi / 2, 0.1), rough(mu, mu), kRadius));
    const double bottom = kRadius * std::numbers::sqrt2;
    hand.to({0, 0, bottom + 0.002});
    hand.go({0, 0, bottom - kDepth}, 0.05);
    QCOMPARE(hand.output().contacts, 2);
    const Vec3 held = hand.output().proxy;
    const double each = kDepth / std::numbers::sqrt2; // the multiplier of each face
    hand.go(hand.finger() + Vec3(0, 0.99 * mu * each, 0), kFine);
    COMPARE_NEAR(hand.output().proxy, held, 1e-8, "m");
    hand.go(hand.finger() + Vec3(0, 0.003, 0), kFine);
    COMPARE_NEAR(-hand.output().force.y(), mu * each * 800, kPart * mu * each * 800, "N");
}

TACTUM_TEST(FrictionStepTest)

} // namespace test_friction_step

#include "test_friction_step.moc"
