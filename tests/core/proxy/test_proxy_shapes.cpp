// The proxy in shapes whose constrained minimum is known exactly: at most 1 um from it at rest, 50 um while
// the finger moves at 0.15 m/s, and not a bit of jitter.

#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/reference.h"
#include "tests/support/test_program.h"

namespace test_proxy_shapes {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kRadius = 1e-3;
constexpr double kStride = kHandSpeed * kMillisecond;
constexpr double kAtRest = 1 * kMicrometre, kMoving = 50 * kMicrometre;

QString micrometres(const char* what, double error) {
    return QString("%1: %2 um").arg(what).arg(error / kMicrometre);
}

// Walks the finger from one place to the next in a convex room, and compares with the room's exact minimum.
class RoomTour {
public:
    RoomTour(Soup soup, const Vec3& inside)
        : rig_(soup, kRadius), walls_(wallsOf(*soup, kRadius, inside)), finger_(inside) {
        rig_.startAt(inside);
    }

    QString walkTo(const Vec3& target) {
        const Vec3 from = finger_;
        const int steps = std::max(1, int(std::ceil((target - from).norm() / kStride)));
        for (int i = 1; i <= steps; ++i) {
            finger_ = from + (target - from) * (double(i) / steps);
            rig_.step(finger_);
            if (const double e = error(); !(e <= kMoving)) return micrometres("moving", e);
        }
        rig_.step(finger_);
        if (const double e = error(); !(e <= kAtRest)) return micrometres("at rest", e);
        const Vec3 resting = rig_.position();
        for (int i = 0; i < 20; ++i) {
            rig_.step(finger_);
            if (rig_.position() != resting) return micrometres("jitter", (rig_.position() - resting).norm());
        }
        return {};
    }

    double error() const { return (rig_.position() - nearestInRoom(finger_, walls_)).norm(); }

private:
    ProxyRig rig_;
    std::vector<ConstraintPlane> walls_;
    Vec3 finger_;
};

// Random fingers below a pit's rim and under its faces.
QString tourOfPit(const std::vector<Vec3>& rays, std::uint64_t seed) {
    Vec3 up = Vec3::Zero();
    for (const Vec3& ray : rays)
        up += ray;
    up.normalize();
    double cosine = 1; // of the widest ray from the axis: how high the centre is in the bottom
    for (const Vec3& ray : rays)
        cosine = std::min(cosine, ray.dot(up));
    RoomTour tour(pit(rays, 0.5), 0.05 * up);
    Rng rng(seed);
    for (int i = 0; i < 12; ++i)
        if (QString wrong = tour.walkTo(0.008 * direction(rng) - 0.002 * up); !wrong.isEmpty()) return wrong;
    return {};
}

} // namespace

class ProxyShapesTest : public QObject {
    Q_OBJECT

private slots:
    void wedge_data();
    void wedge();
    void corner();
    void pits_data();
    void pits();
    void insideOfAPipe();
    void insideOfABall();
    void outsideOfABall();
    void eggCrateHoldsLocalMinima();
    void eggCrateIsFollowedWhileMoving_data();
    void eggCrateIsFollowedWhileMoving();
    void cracksCarryAtTheExactHeight();
    void channelAsWideAsTheProxyLetsItGo();
    void sheetHoldsFromBothSides();
    void fastStrokesDoNotPassAThinPlate();
    void edgesAndPointsAreTouched();
};

void ProxyShapesTest::wedge_data() {
    QTest::addColumn<double>("opening");
    for (int degrees = 5; degrees <= 175; degrees += 5)
        QTest::addRow("%d degrees", degrees) << degrees * std::numbers::pi / 180;
}

void ProxyShapesTest::wedge() {
    QFETCH(double, opening);
    RoomTour tour(test::wedge(opening, 0.2), {0, 0, 0.06});
    // Into the bottom, along it, up under one face, through the bottom to the other.
    for (const Vec3& finger : {Vec3(0, 0, -0.004), Vec3(0.0003, 0.01, -0.002), Vec3(0.006, 0.012, 0.001),
                               Vec3(-0.006, 0.005, -0.001), Vec3(0, 0, 0.06), Vec3(0.001, -0.01, -0.01)})
        QCOMPARE(tour.walkTo(finger), QString());
    // The bottom's line is r / sin(opening / 2) above the valley: the answer without any solver.
    ProxyRig rig(test::wedge(opening, 0.2), kRadius);
    rig.startAt({0, 0, 0.06});
    rig.walk({0, 0, 0.06}, {0, 0.003, -0.004}, kStride, 1);
    COMPARE_NEAR(rig.position(), Vec3(0, 0.003, kRadius / std::sin(opening / 2)), kAtRest, "m");
}

void ProxyShapesTest::corner() {
    const std::vector<std::vector<Vec3>> corners{
        {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()},                                 // square
        {Vec3::UnitX(), Vec3(0.3, 1, 0).normalized(), Vec3(0.5, 0.2, 1).normalized()}, // skewed
        evenRays(3, 0.05),                                                             // shallow
        evenRays(3, 1.3),                                                              // steep
    };
    std::uint64_t seed = 41;
    for (const auto& rays : corners)
        QCOMPARE(tourOfPit(rays, seed++), QString());
}

void ProxyShapesTest::pits_data() {
    QTest::addColumn<int>("faces");
    QTest::addColumn<double>("elevation");
    for (int faces : {4, 6, 12})
        for (double elevation : {0.1, 0.5, 1.0, 1.3})
            QTest::addRow("%d faces, %.1f rad", faces, elevation) << faces << elevation;
}

void ProxyShapesTest::pits() {
    QFETCH(int, faces);
    QFETCH(double, elevation);
    QCOMPARE(tourOfPit(evenRays(faces, elevation), 51), QString());
    // All faces carry at the bottom: its height is r over the sine of a face's steepness to the axis.
    ProxyRig rig(pit(evenRays(faces, elevation), 0.5), kRadius);
    rig.startAt({0, 0, 0.05});
    rig.walk({0, 0, 0.05}, {0, 0, -0.004}, kStride, 1);
    const double apothem = std::cos(std::numbers::pi / faces) / std::tan(elevation);
    COMPARE_NEAR(rig.position(), Vec3(0, 0, kRadius * std::hypot(1, apothem) / apothem), kAtRest, "m");
}

void ProxyShapesTest::insideOfAPipe() {
    RoomTour tour(pipe(0.01, 0.1, 24), Vec3::Zero());
    Rng rng(61);
    for (int i = 0; i < 30; ++i) {
        const double turn = uniform(rng, 0, 7);
        const Vec3 finger(0.013 * std::cos(turn), uniform(rng, -0.05, 0.05), 0.013 * std::sin(turn));
        QCOMPARE(tour.walkTo(finger), QString());
    }
}

void ProxyShapesTest::insideOfABall() {
    RoomTour tour(ball(0.01, 2), Vec3::Zero());
    Rng rng(62);
    for (int i = 0; i < 30; ++i)
        QCOMPARE(tour.walkTo(uniform(rng, 0.005, 0.014) * direction(rng)), QString());
}

// A convex body from outside: the finger's nearest point of the offset body, while it is not deep.
void ProxyShapesTest::outsideOfABall() {
    const Soup soup = ball(0.01, 2);
    ProxyRig rig(soup, kRadius);
    Vec3 finger(0, 0, 0.012);
    rig.startAt(finger);
    Rng rng(63);
    for (int i = 0; i < 200; ++i) {
        const Vec3 target = 0.0095 * (finger.normalized() + 0.3 * direction(rng)).normalized();
        rig.walk(finger, target, kStride, 2);
        finger = target;
        const double error = distanceFromMinimum(*soup, kRadius, rig.position(), finger, kMicrometre / 10);
        QVERIFY2(error <= kAtRest, qPrintable(micrometres("error", error)));
        const Vec3 resting = rig.position();
        rig.step(finger);
        QCOMPARE(rig.position(), resting);
    }
}

void ProxyShapesTest::eggCrateHoldsLocalMinima() {
    const Soup soup = eggCrate(0.02, 40, 0.002, 0.01);
    ProxyRig rig(soup, kRadius);
    Vec3 finger(0, 0, 0.01);
    rig.startAt(finger);
    Rng rng(64);
    for (int i = 0; i < 60; ++i) {
        const Vec3 target(uniform(rng, -0.015, 0.015), uniform(rng, -0.015, 0.015), uniform(rng, -0.006, 0));
        rig.walk(finger, target, kStride, 8);
        finger = target;
        const double error = distanceFromMinimum(*soup, kRadius, rig.position(), finger, kMicrometre / 10);
        QVERIFY2(error <= kAtRest, qPrintable(micrometres("error", error)));
        const Vec3 resting = rig.position();
        rig.step(finger);
        QCOMPARE(rig.position(), resting);
    }
}

void ProxyShapesTest::eggCrateIsFollowedWhileMoving_data() {
    QTest::addColumn<double>("half");
    QTest::addColumn<int>("cells");
    QTest::addColumn<double>("amplitude");
    QTest::addColumn<double>("period");
    QTest::newRow("shallow") << 0.02 << 40 << 0.002 << 0.01;
    QTest::newRow("steep") << 0.02 << 40 << 0.004 << 0.01;
    QTest::newRow("small") << 0.012 << 40 << 0.0015 << 0.006;
    QTest::newRow("coarse") << 0.012 << 30 << 0.0015 << 0.006;
    QTest::newRow("finer than the proxy") << 0.012 << 60 << 0.0004 << 0.0011;
}

// At every step: from crest to crest the proxy falls over dozens of facets within one.
void ProxyShapesTest::eggCrateIsFollowedWhileMoving() {
    QFETCH(const double, half);
    QFETCH(const int, cells);
    QFETCH(const double, amplitude);
    QFETCH(const double, period);
    const Soup soup = eggCrate(half, cells, amplitude, period);
    ProxyRig rig(soup, kRadius), rested(soup, kRadius);
    Vec3 finger(0, 0, 0.01);
    rig.startAt(finger);
    Rng rng(100);
    for (int i = 0; i < 50; ++i) {
        const Vec3 from = finger, target(uniform(rng, -0.8, 0.8) * half, uniform(rng, -0.8, 0.8) * half,
                                         uniform(rng, -2 * amplitude, 0));
        const int steps = std::max(1, int(std::ceil((target - from).norm() / kStride)));
        for (int k = 1; k <= steps; ++k) {
            finger = from + (target - from) * (double(k) / steps);
            rig.step(finger);
            rested.state = rig.state;
            for (SweepMemory& memory : rested.state.memories)
                memory.mesh = nullptr; // the other rig's
            rested.walk(finger, finger, kStride, 20);
            const double error = (rested.position() - rig.position()).norm();
            QVERIFY2(error <= kMoving, qPrintable(micrometres("moving", error)));
        }
    }
}

void ProxyShapesTest::cracksCarryAtTheExactHeight() {
    for (double width : {0.05, 0.5, 1.0, 1.8, 1.99}) {
        const double half = width / 2 * kRadius;
        ProxyRig rig(crack(0.05, 2 * half, 0.02), kRadius);
        rig.startAt({-0.01, 0, 0.005});
        rig.walk({-0.01, 0, 0.005}, {0, 0, -0.003}, kStride, 5);
        const double height = std::sqrt(kRadius * kRadius - half * half);
        QVERIFY2((rig.position() - Vec3(0, 0, height)).norm() <= kAtRest,
                 qPrintable(QString("width %1 r: z %2").arg(width).arg(rig.position().z())));
        // Along the slit, and pulled hard into it.
        rig.walk({0, 0, -0.003}, {0, 0.02, -0.015}, kStride, 5);
        COMPARE_NEAR(rig.position(), Vec3(0, 0.02, height), kAtRest, "m");
    }
}

// Two walls one diameter apart to within the skin and rounding: the proxy that gets in follows the finger
// as on a rail, at every step, and comes out again.
void ProxyShapesTest::channelAsWideAsTheProxyLetsItGo() {
    for (double excess : {-9e-7, -5e-7, -1e-7, -1e-9, 0.0, 1e-9, 1e-7}) {
        const Soup walls = channel(0.02, 2 * kRadius * (1 + excess));
        ProxyRig rig(walls, kRadius);
        rig.startAt({0, 0, 0.03});
        rig.walk({0, 0, 0.03}, {0, 0, 0.01}, kStride, 1);
        for (int i = 1; i <= 100; ++i) {
            const Vec3 pressed = Vec3(0, 0, 0.01) + i * Vec3(5e-6, 2e-5, -5e-5);
            rig.step(pressed);
            const double error = (rig.position() - Vec3(0, pressed.y(), pressed.z())).norm();
            QVERIFY2(error <= kAtRest, qPrintable(micrometres(qPrintable(QString::number(excess)), error)));
        }
        QCOMPARE_GE(clearance(*walls, rig.position()), kRadius - kAtRest);
        rig.walk({0.0005, 0.002, 0.005}, {0, -0.005, 0.03}, kStride, 1);
        COMPARE_NEAR(rig.position(), Vec3(0, -0.005, 0.03), kAtRest, "m");
    }
}

void ProxyShapesTest::sheetHoldsFromBothSides() {
    for (double side : {1.0, -1.0}) {
        ProxyRig rig(sheet(0.05), kRadius);
        rig.startAt({0.01, 0.002, side * 0.004});
        rig.walk({0.01, 0.002, side * 0.004}, {0.01, 0.002, -side * 0.008}, kStride, 1);
        COMPARE_NEAR(rig.position(), Vec3(0.01, 0.002, side * kRadius), kAtRest, "m");
        // Over the diagonal that the two triangles share.
        rig.walk({0.01, 0.002, -side * 0.008}, {-0.01, 0.013, -side * 0.008}, kStride, 1);
        COMPARE_NEAR(rig.position(), Vec3(-0.01, 0.013, side * kRadius), kAtRest, "m");
    }
}

void ProxyShapesTest::fastStrokesDoNotPassAThinPlate() {
    constexpr double speed = 100, thickness = 1e-4;
    Rng rng(65);
    for (int i = 0; i < 200; ++i) {
        ProxyRig rig(plate(0.5, thickness), kRadius);
        Vec3 finger(uniform(rng, -0.1, 0.1), uniform(rng, -0.1, 0.1), uniform(rng, 0.01, 0.09));
        rig.startAt(finger);
        const Vec3 way = speed * kMillisecond * Vec3(uniform(rng, -0.5, 0.5), uniform(rng, -0.5, 0.5), -1);
        for (int k = 0; k < 3; ++k) {
            rig.step(finger += way);
            if (!(finger.z() > 0)) QCOMPARE_GE(rig.position().z(), thickness / 2 + kRadius - kAtRest);
        }
        COMPARE_NEAR(rig.position(), Vec3(finger.x(), finger.y(), thickness / 2 + kRadius), kAtRest, "m");
    }
}

void ProxyShapesTest::edgesAndPointsAreTouched() {
    ProxyRig point(SoupBuilder().point(Vec3::Zero()).build(), kRadius);
    point.startAt({0, 0, 0.005});
    point.walk({0, 0, 0.005}, {0, 0, 0.0002}, kStride, 1);
    COMPARE_NEAR(point.position(), Vec3(0, 0, kRadius), kAtRest, "m");
    point.walk({0, 0, 0.0002}, {0.0003, 0, 0.0004}, kStride, 3);
    COMPARE_NEAR(point.position(), Vec3(0.6, 0, 0.8) * kRadius, kAtRest, "m");
    ProxyRig wire(SoupBuilder().segment({0, -1, 0}, {0, 1, 0}).build(), kRadius);
    wire.startAt({0, 0, 0.005});
    wire.walk({0, 0, 0.005}, {0.0003, 0.02, 0.0004}, kStride, 3);
    COMPARE_NEAR(wire.position(), Vec3(0.6 * kRadius, 0.02, 0.8 * kRadius), kAtRest, "m");
}

TACTUM_TEST(ProxyShapesTest)

} // namespace test_proxy_shapes

#include "test_proxy_shapes.moc"
