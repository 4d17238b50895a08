// Points, segments, and triangles that are felt from one side alone: closed forms of rest, force and letting
// go.

#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/reference.h"
#include "tests/support/test_program.h"

namespace test_primitives {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kRadius = 1e-3;
constexpr double kSpring = 800;

Hand over(Soup soup, const Vec3& from, const Material& material = frictionless()) {
    Hand hand(worldOf(std::move(soup), material, kRadius));
    hand.to(from);
    return hand;
}

Scene oneSided(Soup soup, Sides sides) {
    Scene scene = sceneOf(std::move(soup), frictionless(), kRadius);
    scene.objects[0].surfaces[0].sides = sides;
    return scene;
}

/// Rests the finger there and compares proxy and force with where the proxy must be.
bool restsAt(Hand& hand, const Vec3& finger, const Vec3& proxy) {
    hand.go(finger, kHandSpeed);
    for (int i = 0; i < 5; ++i)
        hand.to(finger);
    const double error = (hand.output().proxy - proxy).norm();
    const double forceError = (hand.output().force - kSpring * (proxy - finger)).norm();
    if (error > kMicrometre || forceError > kSpring * kMicrometre)
        qInfo("%g um, %g mN beside", 1e6 * error, 1e3 * forceError);
    return error <= kMicrometre && forceError <= kSpring * kMicrometre;
}

} // namespace

class PrimitivesTest : public QObject {
    Q_OBJECT

private slots:
    void aPointPushesRadially();
    void thePointIsSlidOffExactlyAtItsEquator();
    void aSegmentPushesAcross();
    void whoBeginsOnAPointOrASegmentIsPutBesideIt();
    void aSegmentEndsInAPoint();
    void aCrossOfWiresHoldsInItsCorner();
    void aCloudOfPointsIsAFloor();
    void frictionHoldsOnAWire();
    void sidesOfASheet_data();
    void sidesOfASheet();
    void aOneSidedBallLetsOutOrIn_data();
    void aOneSidedBallLetsOutOrIn();
    void whatTurnsHalfWayGoesOnPassing_data();
    void whatTurnsHalfWayGoesOnPassing();
    void aSheetThatTurnsHalfWayGoesOnPassing();
    void halfThroughOneWallTheOthersHold();
    void segmentsHaveNoSides();
};

// The C-obstacle of a point is a ball: the proxy rests on the ray from it through the finger.
void PrimitivesTest::aPointPushesRadially() {
    Rng rng(121);
    const Vec3 p(0.001, -0.002, 0.0005);
    const Soup soup = SoupBuilder().point(p).build();
    for (int i = 0; i < 50; ++i) {
        const Vec3 out = direction(rng);
        Hand hand = over(soup, p + 0.004 * out);
        for (int k = 0; k < 5; ++k) {
            const Vec3 toward = (out + 0.6 * inBox(rng, 1)).normalized();
            QVERIFY(restsAt(hand, p + uniform(rng, 0.1, 0.9) * kRadius * toward, p + kRadius * toward));
        }
    }
}

// Pressed down at a depth and drawn sideways the proxy rolls over the point; once the finger is below it the
// proxy comes free, and not before its centre has come down to the side.
void PrimitivesTest::thePointIsSlidOffExactlyAtItsEquator() {
    Hand hand = over(SoupBuilder().point(Vec3::Zero()).build(), {0, 0, 0.003});
    hand.go({1e-6, 0, 0.0001}, kHandSpeed);
    double let = 0;
    hand.go({0.002, 0, 0.0001}, 0.01, [&](const Hand& h) {
        const Vec3 finger = h.finger();
        const Vec3 expected = finger.norm() < kRadius ? Vec3(kRadius * finger.normalized()) : finger;
        QVERIFY2((h.output().proxy - expected).norm() <= 50 * kMicrometre,
                 qPrintable(QString::number(finger.x())));
        if (h.output().contacts > 0) let = finger.x();
    });
    COMPARE_NEAR(let, std::sqrt(kRadius * kRadius - 1e-8), 2e-5, "m"); // a stride of the finger
}

void PrimitivesTest::aSegmentPushesAcross() {
    Rng rng(122);
    const Vec3 a(-0.02, 0.001, 0), b(0.015, -0.004, 0.003), along = (b - a).normalized();
    const Soup soup = SoupBuilder().segment(a, b).build();
    for (int i = 0; i < 50; ++i) {
        const Vec3 out = along.cross(direction(rng)).normalized();
        const Vec3 foot = a + uniform(rng, 0.2, 0.8) * (b - a);
        Hand hand = over(soup, foot + 0.004 * out);
        for (int k = 0; k < 5; ++k) {
            const Vec3 across = (out + 0.6 * along.cross(inBox(rng, 1))).normalized();
            const Vec3 on = a + uniform(rng, 0.1, 0.9) * (b - a);
            QVERIFY(restsAt(hand, on + uniform(rng, 0.2, 0.9) * kRadius * across, on + kRadius * across));
        }
    }
}

// No way out is nearer than another there: any of a radius will do.
void PrimitivesTest::whoBeginsOnAPointOrASegmentIsPutBesideIt() {
    const Vec3 on(0.003, 0, 0);
    for (const Soup& soup :
         {SoupBuilder().point(on).build(), SoupBuilder().segment({-0.01, 0, 0}, {0.02, 0, 0}).build()}) {
        Hand hand = over(soup, on);
        COMPARE_NEAR((hand.output().proxy - on).norm(), kRadius, kMicrometre, "m");
    }
}

// Beyond its end a segment is the point there; farther out the proxy is free.
void PrimitivesTest::aSegmentEndsInAPoint() {
    Hand hand = over(SoupBuilder().segment({-0.01, 0, 0}, {0, 0, 0}).build(), {-0.001, 0, 0.003});
    for (double x : {-0.001, 0.0})
        QVERIFY(restsAt(hand, {x, 0, 0.0003}, {x, 0, kRadius}));
    for (double angle : {0.2, 0.6, 1.0}) {
        const Vec3 toward(std::sin(angle), 0, std::cos(angle));
        QVERIFY(restsAt(hand, 0.5 * kRadius * toward, kRadius * toward));
    }
    QVERIFY(restsAt(hand, {0.002, 0, 0.0003}, {0.002, 0, 0.0003}));
    QCOMPARE(hand.output().contacts, 0);
}

// Two wires cross at a right angle: in the corner between them the proxy touches both.
void PrimitivesTest::aCrossOfWiresHoldsInItsCorner() {
    const Soup soup =
        SoupBuilder().segment({-0.02, 0, 0}, {0.02, 0, 0}).segment({0, -0.02, 0}, {0, 0.02, 0}).build();
    Hand hand = over(soup, {0.002, 0.002, 0.0005});
    const double height = 0.0004, beside = std::sqrt(kRadius * kRadius - height * height);
    // In the plane at that height the wires are walls; the finger is pulled along z by nothing else.
    for (int i = 0; i < 200; ++i)
        hand.to({0.0005 - 1e-6 * i, 0.0005 - 1e-6 * i, height});
    const Vec3 p = hand.output().proxy;
    QCOMPARE(hand.output().contacts, 2);
    COMPARE_NEAR(std::hypot(p.y(), p.z()), kRadius, kMicrometre, "m");
    COMPARE_NEAR(std::hypot(p.x(), p.z()), kRadius, kMicrometre, "m");
    QCOMPARE_GE(p.z(), height);
    QCOMPARE_LE(p.x(), beside + kMicrometre);
    COMPARE_NEAR(p.x(), p.y(), kMicrometre, "m");
}

// Points on a grid of spacing a carry the proxy like a floor: in the pit between four, and on each.
void PrimitivesTest::aCloudOfPointsIsAFloor() {
    constexpr double spacing = 0.0008;
    SoupBuilder cloud;
    for (int i = -20; i <= 20; ++i)
        for (int j = -20; j <= 20; ++j)
            cloud.point({spacing * i, spacing * j, 0});
    const Soup soup = cloud.build();
    Hand hand = over(soup, {0.0002, 0.0001, 0.004});
    hand.go({0.0002, 0.0001, -0.002}, 0.05);
    Rng rng(123);
    for (int i = 0; i < 20; ++i)
        hand.go({uniform(rng, -0.01, 0.01), uniform(rng, -0.01, 0.01), -0.002}, kHandSpeed,
                [&](const Hand& h) {
                    QCOMPARE_GE(clearance(*soup, h.output().proxy), kRadius - kMicrometre);
                    QCOMPARE_GT(h.output().proxy.z(),
                                std::sqrt(kRadius * kRadius - spacing * spacing / 2) - kMicrometre);
                });
    const double pit = std::sqrt(kRadius * kRadius - spacing * spacing / 2);
    const Vec3 middle(spacing / 2, spacing / 2, 0);
    hand.go(middle + Vec3(0, 0, 0.004), kHandSpeed); // out of the pit that it is caught in
    QVERIFY(restsAt(hand, middle - Vec3(0, 0, 0.002), middle + Vec3(0, 0, pit)));
}

// Along a wire friction is that of a plane at the same depth.
void PrimitivesTest::frictionHoldsOnAWire() {
    constexpr double mu = 0.5, depth = 0.0005;
    Hand hand =
        over(SoupBuilder().segment({-0.05, 0, 0}, {0.05, 0, 0}).build(), {0, 0, 0.003}, rough(mu, 0.6 * mu));
    hand.go({0, 0, kRadius - depth}, 0.05);
    double peak = 0;
    hand.go({0.002, 0, kRadius - depth}, 1e-3,
            [&](const Hand& h) { peak = std::max(peak, -h.output().force.x() / h.output().force.z()); });
    COMPARE_NEAR(peak, mu, 0.005 * mu, "");
    COMPARE_NEAR(-hand.output().force.x() / hand.output().force.z(), 0.6 * mu, 0.005 * mu, "");
}

void PrimitivesTest::sidesOfASheet_data() {
    QTest::addColumn<int>("cells");
    QTest::newRow("two triangles") << 1;
    QTest::newRow("fine") << 60;
}

void PrimitivesTest::sidesOfASheet() {
    QFETCH(int, cells);
    for (Sides sides : {Sides::Both, Sides::Front, Sides::Back, Sides::None})
        for (double from : {1.0, -1.0}) {
            Hand hand(compile(oneSided(sheet(0.02, cells), sides)).value());
            hand.to({0.0003, 0.0001, from * 0.004});
            hand.go({0.0003, 0.0001, -from * 0.004}, kHandSpeed);
            const bool felt =
                sides != Sides::None && (sides == Sides::Both || (sides == Sides::Front) == (from > 0));
            QCOMPARE(hand.output().contacts > 0, felt);
            COMPARE_NEAR(hand.output().proxy.z(), from * (felt ? kRadius : -0.004), kMicrometre, "m");
        }
}

void PrimitivesTest::aOneSidedBallLetsOutOrIn_data() {
    QTest::addColumn<int>("divisions");
    QTest::newRow("80 triangles") << 1;
    QTest::newRow("20480 triangles") << 5; // dozens at once inside the proxy
}

// What is felt from outside alone lets the proxy out without a trace of force, and not in again.
void PrimitivesTest::aOneSidedBallLetsOutOrIn() {
    QFETCH(int, divisions);
    const Soup soup = ball(0.008, divisions);
    Rng rng(124);
    for (Sides sides : {Sides::Front, Sides::Back})
        for (int i = 0; i < 10; ++i) {
            const Vec3 out = direction(rng);
            const bool outward = sides == Sides::Front; // the way that is open
            const Vec3 inside = 0.003 * out, outside = 0.012 * out;
            Hand hand(compile(oneSided(soup, sides)).value());
            hand.to(outward ? inside : outside);
            double most = 0;
            hand.go(outward ? outside : inside, 0.3,
                    [&](const Hand& h) { most = std::max(most, h.output().force.norm()); });
            QCOMPARE(hand.output().contacts, 0);
            QCOMPARE_EQ(most, 0);
            hand.go(outward ? inside : outside, 0.3);
            QCOMPARE_GT(hand.output().contacts, 0);
            QCOMPARE_GE(clearance(*soup, hand.output().proxy), kRadius - kMicrometre);
        }
}

void PrimitivesTest::whatTurnsHalfWayGoesOnPassing_data() {
    QTest::addColumn<int>("cells");
    QTest::addColumn<double>("height");
    for (int cells : {1, 60})
        for (double height : {-0.5, 0.1, 0.5, 0.9, 0.999})
            QTest::addRow("%d cells, to %g r", cells, height) << cells << height;
}

// From behind a sheet up to a height above it that its radius still spans, along it, and back: nothing is
// felt. Once it was clear of the sheet it rests on it.
void PrimitivesTest::whatTurnsHalfWayGoesOnPassing() {
    QFETCH(int, cells);
    QFETCH(double, height);
    for (Sides sides : {Sides::Front, Sides::Back}) {
        const double up = sides == Sides::Front ? 1 : -1;
        Hand hand(compile(oneSided(sheet(0.02, cells), sides)).value());
        const auto at = [&](double x, double z) { return Vec3(x, 0.0001, up * z); };
        double most = 0; // of the finger from the proxy
        const auto passes = [&](const Hand& h) {
            most = std::max(most, (h.output().proxy - h.finger()).norm());
        };
        hand.to(at(0, -0.004));
        for (const Vec3& goal : {at(0.0003, height * kRadius), at(0.008, height * kRadius),
                                 at(0.007, -0.9 * kRadius), at(0.002, height * kRadius), at(0, -0.004)})
            hand.go(goal, kHandSpeed, passes);
        hand.go(at(0, 1.01 * kRadius), kHandSpeed, passes);
        QCOMPARE(most, 0.0);
        QVERIFY(restsAt(hand, at(0, -0.004), at(0, kRadius)));
    }
}

// The same with a finger at rest and a sheet that swings through it.
void PrimitivesTest::aSheetThatTurnsHalfWayGoesOnPassing() {
    const Soup soup = sheet(0.02, 60);
    const CollisionMesh mesh{soup, SphereTree(*soup)};
    const std::array<Material, 1> materials{frictionless()};
    const std::array<Sides, 1> sides{Sides::Front};
    Obstacle obstacle{.mesh = &mesh, .materials = materials, .sides = sides, .mover = 0};
    const auto poseAt = [](double height) { return Pose{.translation = {0, 0, height}}; };
    ProxyState state;
    restart(state, Vec3::Zero());
    std::array<BodyMotion, 1> motion{};
    motion[0].now = poseAt(0.003);
    const auto moveTo = [&](double height) {
        motion[0].before = motion[0].now;
        motion[0].now = poseAt(height);
        moveAndUpdate(state, {&obstacle, 1}, kRadius, Vec3::Zero(), kMillisecond, motion);
    };
    for (int i = 0; i <= 200; ++i) {
        moveTo(0.0011 + 0.0019 * std::cos(i * std::numbers::pi / 100)); // 0.8 r below the finger at most
        QCOMPARE(state.position, Vec3(Vec3::Zero()));
    }
    for (double height : {0.001, -0.0005, -0.0015})
        moveTo(height);
    for (int i = 0; i <= 10; ++i)
        moveTo(-0.0015 + 0.0002 * i);
    COMPARE_NEAR(state.position, Vec3(0, 0, 0.0005 + kRadius), kMicrometre, "m");
}

// A corner of a room, felt from inside: half through its floor from below, its wall holds all the same.
void PrimitivesTest::halfThroughOneWallTheOthersHold() {
    const Soup room =
        SoupBuilder()
            .quad({-0.02, -0.02, 0}, {0.02, -0.02, 0}, {0.02, 0.02, 0}, {-0.02, 0.02, 0})
            .quad({0.02, -0.02, -0.02}, {0.02, -0.02, 0.02}, {0.02, 0.02, 0.02}, {0.02, 0.02, -0.02})
            .build();
    Hand hand(compile(oneSided(room, Sides::Front)).value());
    hand.to({0, 0, -0.003});
    hand.go({0, 0, 0.5 * kRadius}, kHandSpeed);
    QVERIFY(restsAt(hand, {0.022, 0, 0.5 * kRadius}, {0.02 - kRadius, 0, 0.5 * kRadius}));
    QVERIFY(restsAt(hand, {0.022, 0, -0.002}, {0.02 - kRadius, 0, -0.002}));
}

void PrimitivesTest::segmentsHaveNoSides() {
    for (Sides sides : {Sides::Front, Sides::Back}) {
        Hand hand(
            compile(oneSided(SoupBuilder().segment({-0.01, 0, 0}, {0.01, 0, 0}).point({0, 0.005, 0}).build(),
                             sides))
                .value());
        hand.to({0, 0.0001, 0.004});
        QVERIFY(restsAt(hand, {0, 0, 0.0005}, {0, 0, kRadius}));
    }
}

TACTUM_TEST(PrimitivesTest)

} // namespace test_primitives

#include "test_primitives.moc"
