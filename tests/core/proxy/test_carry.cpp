// Bodies that move onto the proxy: pushed, never passed, carried.

#include <QTest>

#include "tests/core/proxy/carry_stage.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_carry {

using namespace tactum;
using namespace tactum::test;

class CarryTest : public QObject {
    Q_OBJECT

private slots:
    void aRisingPlatePushes_data();
    void aRisingPlatePushes();
    void aFallingPlateIsFollowed();
    void neverPassesASheet_data();
    void neverPassesASheet();
    void staysInsideAMovingBox_data();
    void staysInsideAMovingBox();
    void staysOutsideAMovingBall();
    void aPaddleTakesTheProxyAround_data();
    void aPaddleTakesTheProxyAround();
    void aNarrowBladeIsMetOnItsArc();
    void isSweptAgainstWalls();
    void eachBodyKeepsItsOwnTriangles();
    void isPushedAlongASlope();
    void ridesOnFriction();
    void doesNotRideWithoutFriction();
    void bodiesOutOfReachChangeNoBit();
    void givesTheSameBits();
    void halfThroughItGoesOnPassing_data();
    void halfThroughItGoesOnPassing();
    void whatTurnsOverItFromBehindIsNotFelt();
    void aCageOfPointsTakesNoMoreSweepsThanPromised();
};

void CarryTest::aRisingPlatePushes_data() {
    QTest::addColumn<double>("speed");
    QTest::addColumn<double>("side");
    for (double speed : {0.001, 0.05, 0.5, 5.0, 50.0, 500.0})
        for (double side : {1.0, -1.0})
            QTest::addRow("%g m/s from %s", speed, side > 0 ? "below" : "above") << speed << side;
}

// The finger stands still in the plate's way; from the touch on the proxy rests at exactly r from the plate.
void CarryTest::aRisingPlatePushes() {
    QFETCH(double, speed);
    QFETCH(double, side);
    for (const Soup& soup : {sheet(0.05), sheet(0.05, 30), plate(0.05, 1e-4)}) {
        const double half = soup->triangles.size() == 4 ? 5e-5 : 0;
        Stage stage;
        const double begin = -3.3 * std::max(kRadius, speed * kMillisecond);
        const int mover = stage.addMover(soup, at({0, 0, side * begin}));
        const Vec3 finger(0.0123, 0.0045, 0);
        stage.startAt(finger);
        for (int i = 1; i <= 12 + int(8 * kRadius / (speed * kMillisecond)); ++i) {
            const double height = begin + speed * kMillisecond * i;
            stage.put(mover, at({0, 0, side * height}));
            QVERIFY(!stage.step(finger).squeezed);
            const Vec3 expected(finger.x(), finger.y(), side * std::max(0.0, height + half + kRadius));
            const double error = (stage.state.position - expected).norm();
            QVERIFY2(error <= kMicrometre + 1e-9 * std::abs(height), inMicrons(error).c_str());
        }
    }
}

void CarryTest::aFallingPlateIsFollowed() {
    for (double mu : {0.0, 0.5}) {
        Stage stage(rough(mu, mu));
        const int mover = stage.addMover(sheet(0.05));
        stage.startAt({0, 0, 0.0011});
        const Vec3 finger(0, 0, -0.02);
        stage.step(finger);
        for (int i = 1; i <= 100; ++i) {
            stage.put(mover, at({0, 0, -3e-4 * i}));
            stage.step(finger);
            const double expected = std::max(finger.z(), -3e-4 * i + kRadius);
            COMPARE_NEAR(stage.state.position.z(), expected, kMicrometre, "m");
        }
    }
}

void CarryTest::neverPassesASheet_data() {
    QTest::addColumn<double>("mu");
    QTest::addColumn<int>("cells");
    QTest::newRow("two triangles") << 0.0 << 1;
    QTest::newRow("fine") << 0.0 << 40;
    QTest::newRow("rough") << 0.6 << 1;
    QTest::newRow("rough and fine") << 0.6 << 40;
}

// A sheet without an end that slides, turns and jolts under a hand that presses and strokes.
void CarryTest::neverPassesASheet() {
    QFETCH(double, mu);
    QFETCH(int, cells);
    Rng rng(101 + cells);
    Stage stage(rough(mu, 0.7 * mu));
    const int mover = stage.addMover(sheet(10, cells));
    stage.startAt({0, 0, 0.003});
    Vec3 finger(0, 0, 0.003);
    for (int i = 0; i < 25000; ++i) {
        const double jolt = i % 50 == 0 ? 0.02 : i % 7 == 0 ? 0.002 : 1e-4;
        stage.put(mover, wandered(stage.pose(mover), rng, jolt, i % 50 == 0 ? 0.3 : 0.01, 0.05));
        if (i % 3) finger += 3e-4 * direction(rng);
        if (finger.norm() > 0.03) finger *= 0.5;
        const ProxyReport report = stage.step(finger);
        QVERIFY(!report.squeezed);
        QVERIFY(!report.passed);
        const double height = stage.inBody(mover).z();
        QVERIFY2(height >= kRadius - kMicrometre, (std::to_string(i) + ": at " + inMicrons(height)).c_str());
    }
}

void CarryTest::staysInsideAMovingBox_data() {
    QTest::addColumn<double>("mu");
    QTest::addColumn<double>("turn");
    for (double mu : {0.0, 0.5})
        for (double turn : {0.0, 0.05, 0.6})
            QTest::addRow("mu %g, turning %g", mu, turn) << mu << turn;
}

void CarryTest::staysInsideAMovingBox() {
    QFETCH(double, mu);
    QFETCH(double, turn);
    Rng rng(103);
    const Vec3 half(0.006, 0.004, 0.009);
    Stage stage(rough(mu, mu));
    const int mover = stage.addMover(box(half));
    stage.startAt(Vec3::Zero());
    int touching = 0;
    for (int i = 0; i < 10000; ++i) {
        stage.put(mover, wandered(stage.pose(mover), rng, i % 20 ? 3e-4 : 8e-3, turn, 0.05));
        // The hand is often outside, where the proxy must not follow it.
        stage.step(i % 5 ? stage.state.finger : stage.pose(mover).translation + inBox(rng, 0.012));
        const Vec3 p_B = stage.inBody(mover);
        QVERIFY2(isInside(p_B, half), std::to_string(i).c_str());
        QVERIFY2(stage.clear() >= kRadius - kMicrometre,
                 (std::to_string(i) + ": " + inMicrons(stage.clear())).c_str());
        touching += stage.state.contactCount > 0;
    }
    QCOMPARE_GT(touching, 2000);
}

void CarryTest::staysOutsideAMovingBall() {
    Rng rng(104);
    for (double mu : {0.0, 0.5}) {
        Stage stage(rough(mu, mu));
        const Soup soup = ball(0.008, 2);
        const int mover = stage.addMover(soup);
        stage.startAt({0, 0, 0.02});
        int touching = 0;
        for (int i = 0; i < 20000; ++i) {
            stage.put(mover, wandered(stage.pose(mover), rng, i % 20 ? 3e-4 : 6e-3, 0.1, 0.02));
            stage.step(i % 5 ? stage.state.finger : inBox(rng, 0.006));
            const double out = stage.inBody(mover).norm();
            QVERIFY2(out > 0.0075 && stage.clear() >= kRadius - kMicrometre,
                     (std::to_string(i) + ": " + inMicrons(stage.clear())).c_str());
            touching += stage.state.contactCount > 0;
        }
        QVERIFY2(touching > 1000, std::to_string(touching).c_str());
    }
}

void CarryTest::aPaddleTakesTheProxyAround_data() {
    QTest::addColumn<double>("turn");
    QTest::addColumn<double>("inner");
    for (double turn : {0.001, 0.01, 0.1, 0.7, 2.0})
        for (double inner : {0.0, 0.045})
            QTest::addRow("%g rad a step, blade from %g m", turn, inner) << turn << inner;
}

// A blade that turns about y meets the proxy at 50 mm from its axis. Seen from the blade the proxy comes on
// an arc; on the chord of a large angle it would miss the blade altogether. It goes around before the blade
// until that leaves it behind at its rim, and is never behind it before.
void CarryTest::aPaddleTakesTheProxyAround() {
    QFETCH(double, turn);
    QFETCH(double, inner);
    SoupBuilder blade;
    blade.quad({inner, -0.05, 0}, {0.055, -0.05, 0}, {0.055, 0.05, 0}, {inner, 0.05, 0});
    Stage stage;
    const int mover = stage.addMover(blade.build());
    // The blade turns from x to -z; the finger is a little before it, and far to the side it pushes to.
    const Vec3 where(0.05 * std::cos(0.3), 0, -0.05 * std::sin(0.3));
    stage.startAt(where);
    double angle = 0;
    bool met = false;
    for (int i = 0; angle + turn < 0.3 + 0.8; ++i) {
        angle += turn;
        stage.put(mover, turned(angle, Vec3::UnitY()));
        stage.step(where);
        const Vec3 p_B = stage.inBody(mover);
        met = met || stage.state.contactCount > 0;
        const bool beyondRim = p_B.x() > 0.055 || p_B.x() < inner;
        QVERIFY2(p_B.z() <= -kRadius + kMicrometre || beyondRim, std::to_string(angle).c_str());
        QCOMPARE_GE(stage.clear(), kRadius - kMicrometre);
    }
    if (turn < 0.7) QVERIFY(met);
}

// A blade of 6 mm turns by 0.7 rad in one step. On the chord the proxy would go by inside of it; on the arc
// it is met, and taken along before it.
void CarryTest::aNarrowBladeIsMetOnItsArc() {
    SoupBuilder blade;
    blade.quad({0.049, -0.05, 0}, {0.055, -0.05, 0}, {0.055, 0.05, 0}, {0.049, 0.05, 0});
    Stage stage;
    const int mover = stage.addMover(blade.build());
    const Vec3 where(0.05 * std::cos(0.35), 0, -0.05 * std::sin(0.35));
    stage.startAt(where);
    stage.step(where);
    stage.put(mover, turned(0.7, Vec3::UnitY()));
    stage.step(stage.pose(mover).apply({0.051, 0, 0.01})); // a finger behind the blade by now
    QCOMPARE_GT(stage.state.contactCount, 0);
    COMPARE_NEAR(stage.inBody(mover).z(), -kRadius, kMicrometre, "m");
    QCOMPARE_GT(stage.inBody(mover).x(), 0.049);
    QCOMPARE_LT(stage.inBody(mover).x(), 0.052);
}

// Pushed toward a wall at rest the proxy stops at it, and slips off sideways where that is open.
void CarryTest::isSweptAgainstWalls() {
    Stage stage;
    stage.addStatic(sheet(0.05), at({0, 0, 0.0205}));
    SoupBuilder ram;
    ram.quad({-0.002, -0.002, 0}, {0.002, -0.002, 0}, {0.002, 0.002, 0}, {-0.002, 0.002, 0});
    const int mover = stage.addMover(ram.build(), at({0, 0, -0.005}));
    const Vec3 finger(0.0005, 0.0002, 0);
    stage.startAt(finger);
    for (int i = 1; i <= 24; ++i) {
        stage.put(mover, at({0, 0, -0.005 + 1e-3 * i}));
        const ProxyReport report = stage.step(finger);
        QVERIFY(!report.passed);
        QVERIFY2(stage.clear() >= kRadius - kMicrometre || report.squeezed, std::to_string(i).c_str());
        QCOMPARE_LE(stage.state.position.z(), 0.0205 - (report.squeezed ? 0 : kRadius - kMicrometre));
    }
}

// Ram and wall are one triangle each, of the same number: what keeps the proxy off the one is not left out of
// the other.
void CarryTest::eachBodyKeepsItsOwnTriangles() {
    SoupBuilder big;
    big.triangle({-0.05, -0.05, 0}, {0.05, -0.05, 0}, {0, 0.08, 0});
    for (const double speed : {1e-4, 9e-4}) {
        Stage stage;
        stage.addStatic(big.build(), at({0, 0, 0.0045}));
        const int mover = stage.addMover(big.build(), at({0, 0, -0.0015}));
        const Vec3 finger(0.0005, 0.0002, 0);
        stage.startAt(finger);
        for (double z = -0.0015; z + 2 * kRadius < 0.0045; z += speed) {
            stage.put(mover, at({0, 0, z}));
            const ProxyReport report = stage.step(finger);
            QVERIFY(!report.passed && !report.squeezed);
            const double expected = std::max(0.0, z + kRadius);
            QVERIFY2(std::abs(stage.state.position.z() - expected) <= kMicrometre,
                     inMicrons(stage.state.position.z() - expected).c_str());
        }
        stage.put(mover, at({0, 0, 0.003})); // half a radius too little
        QVERIFY(stage.step(finger).squeezed);
        QVERIFY2(std::abs(stage.state.position.z() - 0.00375) < kMicrometre,
                 inMicrons(stage.state.position.z()).c_str());
    }
}

// A ram moves along x, the floor rises at 30 degrees: the proxy is pushed up the slope, touching both.
void CarryTest::isPushedAlongASlope() {
    const double slope = std::tan(std::numbers::pi / 6);
    Stage stage;
    stage.addStatic(heightField(0.1, 1, [slope](double x, double) { return slope * x; }));
    SoupBuilder ram;
    ram.quad({0, -0.1, -0.1}, {0, 0.1, -0.1}, {0, 0.1, 0.1}, {0, -0.1, 0.1});
    const int mover = stage.addMover(ram.build(), at({-0.01, 0, 0}));
    const Vec3 finger(0, 0, -0.01);
    stage.startAt({0, 0, 0.01});
    for (int i = 0; i < 40; ++i)
        stage.step(Vec3(0, 0, 0.01 - 0.0005 * i));
    for (int i = 1; i <= 50; ++i) {
        const double x = -0.01 + 1e-3 * i;
        stage.put(mover, at({x, 0, 0}));
        stage.step(finger);
        const double px = std::max(x + kRadius, stage.state.position.x());
        const Vec3 expected(px, 0, slope * px + kRadius * std::sqrt(1 + slope * slope));
        if (x + kRadius > 0)
            QVERIFY2((stage.state.position - expected).norm() <= kMicrometre,
                     inMicrons((stage.state.position - expected).norm()).c_str());
    }
    QCOMPARE_GT(stage.state.position.x(), 0.04);
}

// Held by static friction the proxy keeps its place on the body, whatever that does.
void CarryTest::ridesOnFriction() {
    Rng rng(106);
    Stage stage(rough(2, 2));
    const int mover = stage.addMover(sheet(1, 10));
    stage.startAt({0.01, 0.02, 0.0011});
    const Vec3 finger_B(0.01, 0.02, -0.003);
    stage.step(finger_B);
    const Vec3 held = stage.inBody(mover);
    for (int i = 0; i < 5000; ++i) {
        stage.put(mover, wandered(stage.pose(mover), rng, 1e-3, 0.05, 0.05));
        stage.step(stage.pose(mover).apply(finger_B)); // the hand goes along
        QVERIFY2((stage.inBody(mover) - held).norm() < 2 * kSkin * kRadius,
                 inMicrons((stage.inBody(mover) - held).norm()).c_str());
        QVERIFY(!stage.state.contacts[0].slipping);
    }
}

void CarryTest::doesNotRideWithoutFriction() {
    Stage stage;
    const int mover = stage.addMover(sheet(1, 10));
    stage.startAt({0, 0, 0.0011});
    stage.step({0, 0, -0.001});
    for (int i = 1; i < 500; ++i) {
        stage.put(mover, at({1e-3 * i, -3e-4 * i, 0}));
        stage.step({0, 0, -0.001});
        COMPARE_NEAR(stage.state.position, Vec3(0, 0, kRadius), 1e-9, "m");
    }
}

// Fast bodies elsewhere in the scene are left out before any sweep, and alter nothing.
void CarryTest::bodiesOutOfReachChangeNoBit() {
    Rng rng(107);
    Stage alone(rough(0.4, 0.3)), among(rough(0.4, 0.3));
    alone.addStatic(eggCrate(0.02, 20, 0.001, 0.008));
    among.addStatic(eggCrate(0.02, 20, 0.001, 0.008));
    const int mover = among.addMover(ball(0.01, 2), at({0.5, 0, 0}));
    alone.startAt({0, 0, 0.005});
    among.startAt({0, 0, 0.005});
    for (int i = 0; i < 2000; ++i) {
        among.put(mover, turned(0.4 * i, Vec3::UnitZ(), {0.5, 0.01 * (i % 7), 0}));
        const Vec3 finger(0.01 * std::sin(0.01 * i), 0.01 * std::cos(0.013 * i), -0.001);
        alone.step(finger);
        among.step(finger);
        QCOMPARE(alone.state.position, among.state.position);
    }
}

void CarryTest::givesTheSameBits() {
    std::vector<Vec3> places;
    for (int run = 0; run < 2; ++run) {
        Rng rng(108);
        Stage stage(rough(0.5, 0.3, 0.5));
        const int first = stage.addMover(ball(0.006, 2)), second = stage.addMover(box({0.01, 0.01, 0.001}));
        stage.addStatic(eggCrate(0.02, 20, 0.001, 0.008), at({0, 0, -0.005}));
        stage.startAt({0, 0, 0.02});
        for (int i = 0; i < 3000; ++i) {
            stage.put(first, wandered(stage.pose(first), rng, 5e-4, 0.1, 0.02));
            stage.put(second, wandered(stage.pose(second), rng, 5e-4, 0.1, 0.02));
            stage.step(0.02 * Vec3(std::sin(0.01 * i), std::cos(0.017 * i), -0.3));
            if (run == 0)
                places.push_back(stage.state.position);
            else
                QCOMPARE(stage.state.position, places[std::size_t(i)]);
        }
    }
}

void CarryTest::halfThroughItGoesOnPassing_data() {
    QTest::addColumn<bool>("jumped");
    QTest::newRow("a plate that moves") << false;
    QTest::newRow("a plate that jumps") << true;
}

// From behind, half through a plate that goes a hundredth of a radius meanwhile.
void CarryTest::halfThroughItGoesOnPassing() {
    QFETCH(bool, jumped);
    Stage stage;
    stage.addMover(sheet(0.02));
    stage.feelFrom(0, Sides::Front);
    stage.startAt({0, 0, -2 * kRadius});
    for (int i = 0; i <= 23; ++i)
        stage.step({0, 0, (0.1 * i - 2) * kRadius});
    stage.put(0, at({0.01 * kRadius, 0, 0}), jumped);
    for (const Vec3& finger : {Vec3(0, 0, 0.3 * kRadius), Vec3(0.1 * kRadius, 0, 0.2 * kRadius)}) {
        stage.step(finger);
        COMPARE_NEAR(stage.state.position, finger, 1e-12, "m");
    }
}

// A plate that is felt from above alone comes down over the proxy while it turns, in many pieces; then
// another pushes: there is nothing beneath.
void CarryTest::whatTurnsOverItFromBehindIsNotFelt() {
    for (const double turn : {0.0, 0.1, 0.3}) {
        Stage stage;
        stage.addMover(sheet(0.04), at({0.01, 0, 1.05 * kRadius}));
        stage.addMover(sheet(0.04), at({0, 0, 2.5 * kRadius}));
        stage.feelFrom(0, Sides::Front);
        stage.startAt(Vec3::Zero());
        stage.put(0, turned(turn, Vec3::UnitZ(), {0.01, 0, -0.7 * kRadius}));
        stage.put(1, at({0, 0, 0.5 * kRadius}));
        const ProxyReport report = stage.step(Vec3::Zero());
        QVERIFY(!report.squeezed);
        QVERIFY(!report.passed);
        COMPARE_NEAR(stage.state.position.z(), -0.5 * kRadius, kMicrometre, "m");
    }
}

// Points all around the proxy, hardly farther away than its radius, and among them others that move by a
// radius at once: what it is kept out of pushes it into the next. The worst of 30,000 cages, some of which
// settle with the last sweep and some of which do not.
void CarryTest::aCageOfPointsTakesNoMoreSweepsThanPromised() {
    int most = 0, settled = 0, passed = 0; // of those that take most
    for (const int cage : {1208, 4025, 4814, 7854, 8777, 9267}) {
        Rng rng{std::uint64_t(cage)};
        const auto points = [&rng](int count) {
            SoupBuilder builder;
            for (int i = 0; i < count; ++i) {
                const double away = kRadius * uniform(rng, 1.0001, 1.1);
                builder.point(away * direction(rng));
            }
            return builder.build();
        };
        Stage stage;
        stage.addStatic(points(400));
        const int mover = stage.addMover(points(100));
        stage.startAt(Vec3::Zero());
        stage.put(mover, at(kRadius * direction(rng)));
        const CarryReport report = stage.carryAlone();
        QVERIFY2(report.sweeps <= kMaxCarryRounds + 1, qPrintable(QString("cage %1: %2 sweeps instead of %3")
                                                                      .arg(cage)
                                                                      .arg(report.sweeps)
                                                                      .arg(kMaxCarryRounds + 1)));
        most = std::max(most, report.sweeps);
        if (report.sweeps <= kMaxCarryRounds) continue;
        (report.passed ? passed : settled) += 1;
    }
    QCOMPARE(most, kMaxCarryRounds + 1);
    QVERIFY2(settled >= 2 && passed >= 2, qPrintable(QString("%1 %2").arg(settled).arg(passed)));
}

TACTUM_TEST(CarryTest)

} // namespace test_carry

#include "test_carry.moc"
