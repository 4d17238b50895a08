// Balls, capsules and cylinders against each other.
//
// What would show that a test here is wrong: distances are found a second time by going to and fro between
// the nearest points of both bodies, which knows nothing of pairs; a body that is 1 % thicker is nearer by
// just that. What rolls is held against its equation of motion, integrated here in small steps; with the
// moment of another body, or where friction is none, it goes elsewhere.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <QTest>

#include "core/dynamics/round/pairs.h"
#include "tests/core/dynamics/loose.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_round {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double kMuch = 1e3; // m: all places are near

/// What is nearest in a body to a point, by the meaning of the words.
Vec3 nearestIn(const ColliderShape& shape, const Pose& pose, const Vec3& point) {
    const Vec3 p = pose.applyInverse(point);
    const double half = shape.kind == ShapeKind::Sphere ? 0 : shape.height / 2;
    const Vec3 core(0, std::clamp(p.y(), -half, half), 0);
    Vec3 to = p - core;
    if (shape.kind == ShapeKind::Cylinder) to.y() = 0;
    const double far = to.norm();
    return pose.apply(far > shape.radius ? Vec3(core + shape.radius / far * to) : Vec3(core + to));
}

/// Von Neumann's alternating projections end at the distance of two convex bodies that do not meet.
double distanceOf(const ColliderShape& a, const Pose& a_W, const ColliderShape& b, const Pose& b_W) {
    Vec3 onA = a_W.translation, onB = b_W.translation;
    for (int i = 0; i < 20000; ++i) {
        onB = nearestIn(b, b_W, onA);
        onA = nearestIn(a, a_W, onB);
    }
    return (onB - onA).norm();
}

const std::array kKinds{ShapeKind::Sphere, ShapeKind::Capsule, ShapeKind::Cylinder};
const char* nameOf(ShapeKind kind) {
    return kind == ShapeKind::Sphere ? "ball" : kind == ShapeKind::Capsule ? "capsule" : "cylinder";
}

std::optional<TouchPoints> touch(const ColliderShape& a, const Pose& a_W, const ColliderShape& b,
                                 const Pose& b_W, double margin = kMuch) {
    return touchRound(convexOf(a), a_W, convexOf(b), b_W, margin);
}
double leastGap(const TouchPoints& points) {
    double least = kUnbounded;
    for (const TouchPoint& point : points.all())
        least = std::min(least, point.gap);
    return least;
}

/// Turned so that what is round about y lies along z.
Pose lying(const Vec3& at) {
    return {Quat(Eigen::AngleAxisd(pi / 2, Vec3::UnitX())), at};
}

/// x'' = f(x, x') from rest or not, fourth order, in steps far smaller than those of what is tested.
template <class F> void integrate(double& x, double& v, double seconds, const F& f) {
    const int steps = int(std::ceil(seconds / 1e-5));
    const double h = seconds / steps;
    for (int i = 0; i < steps; ++i) {
        const double a1 = f(x, v), a2 = f(x + h / 2 * v, v + h / 2 * a1),
                     a3 = f(x + h / 2 * v + h * h / 4 * a1, v + h / 2 * a2),
                     a4 = f(x + h * v + h * h / 2 * a2, v + h * a3);
        x += h * v + h * h / 6 * (a1 + a2 + a3);
        v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
}

} // namespace

class RoundTest : public QObject {
    Q_OBJECT

private slots:
    void theyAreAsFarAsTheyAre_data();
    void theyAreAsFarAsTheyAre();
    void sideBySideTheyTouchAtBothEnds_data();
    void sideBySideTheyTouchAtBothEnds();
    void whatHasAnEndIsForOthers();
    void oneRollsOffAnother_data();
    void oneRollsOffAnother();
    void oneRollsOnAWheelThatTurns_data();
    void oneRollsOnAWheelThatTurns();
    void oneThatLiesAcrossRocks_data();
    void oneThatLiesAcrossRocks();
    void aCapsuleLiesOnAnEnd();
};

void RoundTest::theyAreAsFarAsTheyAre_data() {
    QTest::addColumn<ShapeKind>("first");
    QTest::addColumn<ShapeKind>("second");
    for (const ShapeKind first : kKinds)
        for (const ShapeKind second : kKinds)
            QTest::addRow("%s and %s", nameOf(first), nameOf(second)) << first << second;
}

void RoundTest::theyAreAsFarAsTheyAre() {
    QFETCH(ShapeKind, first);
    QFETCH(ShapeKind, second);
    std::mt19937 random(1);
    const auto number = [&](double low, double high) {
        return std::uniform_real_distribution(low, high)(random);
    };
    const auto shape = [&](ShapeKind kind) { return lengthwise(kind, number(0.1, 0.5), number(0.2, 1.5)); };
    const auto pose = [&] {
        return Pose{Quat(number(-1, 1), number(-1, 1), number(-1, 1), number(-1, 1)).normalized(),
                    Vec3(number(-1, 1), number(-1, 1), number(-1, 1))};
    };
    int compared = 0;
    for (int i = 0; i < 150; ++i) {
        ColliderShape a = shape(first), b = shape(second);
        const Pose a_W = pose(), b_W = pose();
        const double far = distanceOf(a, a_W, b, b_W);
        const auto points = touch(a, a_W, b, b_W);
        if (far < 1e-3 || !points) continue;
        ++compared;
        COMPARE_NEAR(leastGap(*points), far, 1e-5, "m");
        for (const TouchPoint& at : points->all()) { // on both surfaces, and square to one of them
            const Vec3 onA = at.point - 0.5 * at.gap * at.normal, onB = at.point + 0.5 * at.gap * at.normal;
            COMPARE_NEAR(nearestIn(a, a_W, onA), onA, 1e-9, "m");
            COMPARE_NEAR(nearestIn(b, b_W, onB), onB, 1e-9, "m");
            COMPARE_NEAR(at.normal.norm(), 1, 1e-12, "");
        }
        const auto back = touch(b, b_W, a, a_W);
        QVERIFY(back);
        COMPARE_NEAR(leastGap(*back), leastGap(*points), 1e-9, "m");
        QVERIFY(touch(a, a_W, b, b_W, 0.9 * far)->size() == 0); // none within a margin that is too small
        // Overlapping by 2 % of a radius what was apart: what is round is thicker.
        if (first != ShapeKind::Sphere || second != ShapeKind::Sphere) continue;
        a.radius = a.radiusBottom = a.radius + far + 0.02;
        COMPARE_NEAR(leastGap(*touch(a, a_W, b, b_W)), -0.02, 1e-9, "m");
    }
    // Few cylinders that lie anyhow meet with their sides.
    const bool cylinders = first == ShapeKind::Cylinder && second == ShapeKind::Cylinder;
    QCOMPARE_GT(compared, cylinders ? 8 : 50);
}

void RoundTest::sideBySideTheyTouchAtBothEnds_data() {
    QTest::addColumn<ShapeKind>("first");
    QTest::addColumn<ShapeKind>("second");
    for (const ShapeKind first : {ShapeKind::Capsule, ShapeKind::Cylinder})
        for (const ShapeKind second : {ShapeKind::Capsule, ShapeKind::Cylinder})
            QTest::addRow("%s and %s", nameOf(first), nameOf(second)) << first << second;
}

// The upper one 2 m long and the lower one 1 m, which is 0.2 m farther along: from -0.3 to 0.7. And the other
// way round, and with the upper one beyond the end of the lower one.
void RoundTest::sideBySideTheyTouchAtBothEnds() {
    QFETCH(ShapeKind, first);
    QFETCH(ShapeKind, second);
    const ColliderShape longer = lengthwise(first, 0.1, 2), shorter = lengthwise(second, 0.2, 1);
    const double gap = 1e-5;
    const auto compare = [&](const Vec3& at, double from, double to) {
        const auto points = touch(shorter, lying(at), longer, lying(Vec3(0, 0.3 + gap, 0)), 1e-4);
        QVERIFY(points);
        QCOMPARE(points->size(), std::size_t(2));
        std::array<double, 2> ends{(*points)[0].point.z(), (*points)[1].point.z()};
        std::ranges::sort(ends);
        COMPARE_NEAR(ends[0], from, 1e-6, "m");
        COMPARE_NEAR(ends[1], to, 1e-6, "m");
        for (const TouchPoint& point : points->all()) {
            COMPARE_NEAR(point.gap, gap, 1e-9, "m");
            COMPARE_NEAR(point.normal, Vec3(0, 1, 0), 1e-9, "");
            COMPARE_NEAR(point.point.y(), 0.2 + gap / 2, 1e-9, "m");
        }
    };
    compare(Vec3(0, 0, 0.2), -0.3, 0.7);
    compare(Vec3(0, 0, 0.8), 0.3, 1.0);
}

// A cylinder that stands on another one's end, or lies on it, or leans on it with its rim: polytopes. And
// what is no cylinder but a cone is none of the round ones.
void RoundTest::whatHasAnEndIsForOthers() {
    const ColliderShape can = lengthwise(ShapeKind::Cylinder, 0.1, 0.2);
    QVERIFY(!touch(can, at(0, 0), can, at(0, 0.2)));
    QVERIFY(!touch(can, at(0, 0), can, at(0, 0.1999)));
    QVERIFY(!touch(can, at(0, 0), can, lying(Vec3(0, 0.2, 0))));
    QVERIFY(!touch(can, at(0, 0), can, {Quat(Eigen::AngleAxisd(0.7, Vec3::UnitX())), Vec3(0, 0.25, 0)}));
    QVERIFY(!touch(can, at(0, 0), box({1, 1, 1}), at(0, 0.6)));
    ColliderShape cone = can;
    cone.radius = 0.05;
    QVERIFY(!touch(cone, at(0, 0), lengthwise(ShapeKind::Sphere, 0.1, 1), at(0.2, 0)));
    QVERIFY(touch(can, at(0, 0), can, at(0.2, 0)));
}

void RoundTest::oneRollsOffAnother_data() {
    QTest::addColumn<ShapeKind>("lower");
    QTest::addColumn<ShapeKind>("upper");
    QTest::addColumn<double>("radius");
    for (const ShapeKind lower : kKinds)
        for (const ShapeKind upper : kKinds)
            for (const double radius : {0.2, 0.05})
                QTest::addRow("%s on %s, %g m", nameOf(upper), nameOf(lower), radius)
                    << lower << upper << radius;
}

// From 0.05 rad off the top of one of 1 m that stands still: (1 + k) (R + r) theta'' = g sin(theta), with
// k = I / (m r^2), until nothing presses any more, cos(theta) = 2 cos(theta0) / (3 + k).
void RoundTest::oneRollsOffAnother() {
    QFETCH(ShapeKind, lower);
    QFETCH(ShapeKind, upper);
    QFETCH(double, radius);
    if (lower == ShapeKind::Sphere && upper != ShapeKind::Sphere) return; // it would fall off to a side
    World world;
    world.material = {1e3, 1e3, 0, Combine::Average, Combine::Average};
    const double large = 1, start = 0.05, both = large + radius;
    world.addStill(lengthwise(lower, large, 2), lying(Vec3::Zero()));
    const Vec3 place = both * Vec3(std::sin(start), std::cos(start), 0);
    const RigidBody& body = world.add(lengthwise(upper, radius, 0.5), lying(place), 1);
    const double k = body.inertia.y() / (body.mass * radius * radius), end = 2 * std::cos(start) / (3 + k);
    Running run(world.mechanics);
    double theta = start, rate = 0;
    const double dt = 1e-3;
    for (; std::cos(theta) > end; integrate(
             theta, rate, dt, [&](double x, double) { return 9.81 / ((1 + k) * both) * std::sin(x); })) {
        const BodyState& now = run.bodies()[0];
        COMPARE_NEAR(std::atan2(now.centre.x(), now.centre.y()), theta, 1e-4 * theta, "rad");
        COMPARE_NEAR(now.angularVelocity.norm() * radius, rate * both, 1e-4 * rate * both + 1e-9, "m/s");
        COMPARE_NEAR(now.centre.z(), 0, 1e-9, "m");
        COMPARE_NEAR(std::hypot(now.centre.x(), now.centre.y()), both, 1e-5, "m");
        run.run(dt, dt);
    }
}

void RoundTest::oneRollsOnAWheelThatTurns_data() {
    QTest::addColumn<ShapeKind>("lower");
    QTest::addColumn<ShapeKind>("upper");
    for (const ShapeKind lower : {ShapeKind::Capsule, ShapeKind::Cylinder})
        for (const ShapeKind upper : kKinds)
            QTest::addRow("%s on %s", nameOf(upper), nameOf(lower)) << lower << upper;
}

// The wheel gives way with R^2 / I of its own beside r^2 / i of what rolls: together they hold it back with
// 1 / (r^2 / i + R^2 / I) more than its mass.
void RoundTest::oneRollsOnAWheelThatTurns() {
    QFETCH(ShapeKind, lower);
    QFETCH(ShapeKind, upper);
    World world;
    world.material = {1e3, 1e3, 0, Combine::Average, Combine::Average};
    const double large = 0.3, small = 0.1, both = large + small, start = 0.05, mass = 2;
    const double wheel = world.add(lengthwise(lower, large, 1), lying(Vec3::Zero()), 1).inertia.y();
    const Vec3 place = both * Vec3(std::sin(start), std::cos(start), 0);
    const double moment = world.add(lengthwise(upper, small, 0.4), lying(place), mass).inertia.y();
    world.mechanics.joints.push_back(hingeAt(world.mechanics.bodies, kWorldBody, 1, Vec3::Zero()));
    Running run(world.mechanics);
    const double holds = 1 / (small * small / moment + large * large / wheel);
    double theta = start, rate = 0;
    for (; 9.81 * std::cos(theta) > both * rate * rate; integrate(theta, rate, 1e-3, [&](double x, double) {
             return mass * 9.81 * std::sin(x) / (both * (mass + holds));
         })) {
        const Vec3& centre = run.bodies()[1].centre;
        COMPARE_NEAR(std::atan2(centre.x(), centre.y()), theta, 1e-4 * theta, "rad");
        COMPARE_NEAR(centre.norm(), both, 1e-5, "m");
        const double push = holds * both * rate; // the momentum that the friction made
        COMPARE_NEAR(run.bodies()[0].angularVelocity.z(), -push * large / wheel,
                     1e-3 * push * large / wheel + 1e-9, "rad/s");
        run.run(1e-3, 1e-3);
    }
}

void RoundTest::oneThatLiesAcrossRocks_data() {
    QTest::addColumn<ShapeKind>("lower");
    QTest::addColumn<ShapeKind>("upper");
    for (const ShapeKind lower : kKinds)
        for (const ShapeKind upper : {ShapeKind::Capsule, ShapeKind::Cylinder})
            QTest::addRow("%s on %s", nameOf(upper), nameOf(lower)) << lower << upper;
}

// A rod of radius r across the top of a roller R, tilted by phi: it touches R phi from its middle, turns
// about that place, and has m g ((R + r) cos(phi) + R phi sin(phi)) of height.
void RoundTest::oneThatLiesAcrossRocks() {
    QFETCH(ShapeKind, lower);
    QFETCH(ShapeKind, upper);
    World world;
    world.material = {10, 10, 0, Combine::Average, Combine::Average};
    const double large = 0.3, small = 0.05, start = 0.2;
    world.addStill(lengthwise(lower, large, 1), lying(Vec3::Zero()));
    const Quat tilt(Eigen::AngleAxisd(-start, Vec3::UnitZ()));
    const Pose across{tilt * Quat(Eigen::AngleAxisd(pi / 2, Vec3::UnitZ())),
                      tilt * Vec3(-large * start, large + small, 0)};
    const double moment = world.add(lengthwise(upper, small, 0.8), across, 1).inertia.x();
    Running run(world.mechanics);
    double phi = start, rate = 0;
    for (int i = 0; i < 1000; ++i) {
        run.run(1e-3, 1e-3);
        integrate(phi, rate, 1e-3, [&](double x, double v) {
            const double turn = 9.81 * (small * std::sin(x) - large * x * std::cos(x));
            return (turn - large * large * x * v * v) / (moment + small * small + large * large * x * x);
        });
        const Vec3 along = run.bodies()[0].pose.rotation * Vec3(0, -1, 0);
        COMPARE_NEAR(std::atan2(-along.y(), along.x()), phi, 3e-4 * start, "rad");
    }
}

// Across the flat end of a cylinder that stands: it stays, and bears on what lies over the end.
void RoundTest::aCapsuleLiesOnAnEnd() {
    World world;
    world.addStill(lengthwise(ShapeKind::Cylinder, 0.2, 0.1), at(0, -0.05));
    world.add(lengthwise(ShapeKind::Capsule, 0.03, 0.8), lying(Vec3(0.1, 0.03, 0.05)), 1);
    Running run(world.mechanics);
    run.run(1, 1e-3);
    COMPARE_NEAR(run.bodies()[0].centre, Vec3(0.1, 0.03, 0.05), 2e-5, "m");
    COMPARE_NEAR(run.bodies()[0].velocity, Vec3::Zero(), 1e-5, "m/s");
}

TACTUM_TEST(RoundTest)

} // namespace test_round

#include "test_round.moc"
