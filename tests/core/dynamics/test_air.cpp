// Bodies that air slows: falls and spins whose laws are known, and that it never drives anything.
//
// What would show that a test here is wrong: the laws are those of one axis alone, so that a force along the
// wrong one, or about another point, is off at once; without air there is nothing that could act
// (withoutAirThereIsNone).
#include <cmath>
#include <random>

#include <QTest>

#include "tests/core/dynamics/mechanisms.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_air {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kAir = 1.2;

Collider boxOn(BodyId body, const Vec3& size, const Pose& at = {}) {
    Collider collider;
    collider.body = body;
    collider.pose = at;
    collider.shape.size = size;
    return collider;
}

/// A plate of 0.1 x 0.02 x 0.3 m.
Mechanics plate(double mass, const Quat& turned, double air = kAir) {
    Mechanics scene;
    scene.airDensity = air;
    RigidBody body = bodyAt(1, Vec3::Zero(), mass, Vec3(1e-3, 2e-3, 3e-3));
    body.pose.rotation = turned;
    scene.bodies = {body};
    scene.colliders = {boxOn(1, Vec3(0.1, 0.02, 0.3))};
    return scene;
}

double kineticOf(Running& run) {
    double sum = 0;
    for (const BodyState& body : run.bodies())
        sum += body.kinetic;
    return sum;
}

} // namespace

class AirTest : public QObject {
    Q_OBJECT

private slots:
    void aFallEndsAtItsTerminalSpeed_data();
    void aFallEndsAtItsTerminalSpeed();
    void aSpinDiesAway();
    void theBoxIsAroundAllColliders();
    void whatTrailsTurnsAnArrow();
    void aPendulumLosesWhatTheAirTakes();
    void grainsNeverGainSpeed_data();
    void grainsNeverGainSpeed();
    void mechanismsNeverGainEnergy();
    void withoutAirThereIsNone();
};

void AirTest::aFallEndsAtItsTerminalSpeed_data() {
    QTest::addColumn<int>("down"); // which axis of the plate
    QTest::addColumn<double>("area");
    QTest::newRow("x") << 0 << 0.02 * 0.3;
    QTest::newRow("y") << 1 << 0.1 * 0.3;
    QTest::newRow("z") << 2 << 0.1 * 0.02;
}

// m v' = m g - rho / 2 A v^2: v = u tanh(g t / u).
void AirTest::aFallEndsAtItsTerminalSpeed() {
    QFETCH(int, down);
    QFETCH(double, area);
    const double mass = 0.01, end = std::sqrt(2 * mass * 9.81 / (kAir * area));
    Running run(plate(mass, turnOnto(Vec3::Unit(down), -Vec3::UnitY())));
    for (int i = 1; i <= 20; ++i) {
        run.run(0.1, 2e-4);
        COMPARE_NEAR(run.bodies()[0].velocity, Vec3(0, -end * std::tanh(9.81 * 0.1 * i / end), 0), 1e-9,
                     "m/s");
    }
}

// I w' = -rho / 64 b (l^4 + m^4) w^2: w = w0 / (1 + k w0 t).
void AirTest::aSpinDiesAway() {
    Mechanics scene = plate(0.01, Quat::Identity());
    scene.bodies[0].angularVelocity = Vec3(0, 50, 0);
    Running run(scene);
    const double k = kAir / 64 * 0.02 * (std::pow(0.1, 4) + std::pow(0.3, 4)) / 2e-3;
    run.run(3, 1e-3, Vec3::Zero());
    COMPARE_NEAR(run.bodies()[0].angularVelocity, Vec3(0, 50 / (1 + k * 50 * 3), 0), 1e-9, "rad/s");
}

// A ball and a bar that is turned by a quarter: 0.1 x 0.02 x 0.3 m together, as the plate.
void AirTest::theBoxIsAroundAllColliders() {
    Mechanics scene = plate(0.01, Quat::Identity());
    const Quat quarter(Eigen::AngleAxisd(1.5707963267948966, Vec3::UnitY()));
    Collider bar = boxOn(1, Vec3(0.3, 0.02, 0.02), {quarter, Vec3(-0.04, 0, 0)});
    Collider ball;
    ball.body = 1;
    ball.shape.kind = ShapeKind::Sphere;
    ball.shape.radius = 0.01;
    ball.pose.translation = Vec3(0.04, 0, 0.1);
    scene.colliders = {bar, ball};
    scene.bodies[0].velocity = Vec3(3, -2, 1);
    scene.bodies[0].angularVelocity = Vec3(1, 2, 3);
    Mechanics whole = plate(0.01, Quat::Identity());
    whole.bodies = scene.bodies;
    Running parts(scene), one(whole);
    parts.run(0.5, 1e-3), one.run(0.5, 1e-3);
    COMPARE_NEAR(parts.bodies()[0].centre, one.bodies()[0].centre, 1e-12, "m");
    QCOMPARE_GT((one.bodies()[0].centre - Vec3(1.5, -1 - 0.5 * 9.81 * 0.25, 0.5)).norm(), 1e-2);
}

// What is slowed behind its centre of mass turns into the wind.
void AirTest::whatTrailsTurnsAnArrow() {
    Mechanics scene = plate(0.1, Quat::Identity());
    scene.bodies[0].centre = Vec3(0, 0, 0.14);
    scene.bodies[0].velocity = Vec3(0.5, 0, 5);
    Running run(scene);
    run.run(0.2, 1e-3, Vec3::Zero());
    QCOMPARE_GT(run.bodies()[0].angularVelocity.y(), 0.01); // from z toward x
}

// On a hinge: M = -rho / 2 A l^3 w^2 of the middle, and the spin about it. Its energy goes by the power.
void AirTest::aPendulumLosesWhatTheAirTakes() {
    Mechanics scene = plate(0.2, Quat::Identity());
    const double l = 0.25, inertia = 1e-3 + 0.2 * l * l;
    scene.joints = {hingeAt(scene.bodies, kWorldBody, 1, Vec3(0, l, 0), Vec3::UnitX())};
    scene.bodies[0].velocity = Vec3(0, 0, 4);
    Running run(scene);
    const double w0 = run.state().v[0];
    run.run(1, 1e-4, Vec3::Zero());
    const double spin = kAir / 64 * 0.1 * (std::pow(0.02, 4) + std::pow(0.3, 4));
    const double k = (kAir / 2 * 0.1 * 0.02 * l * l * l + spin) / inertia;
    COMPARE_NEAR(run.state().v[0], w0 / (1 + k * std::abs(w0)), 1e-9, "rad/s");
}

void AirTest::grainsNeverGainSpeed_data() {
    QTest::addColumn<double>("density");
    QTest::addColumn<double>("speed");
    for (const double density : {1.2, 1000.0})
        for (const double speed : {0.1, 10.0, 1000.0})
            QTest::addRow("%g kg/m^3, %g m/s", density, speed) << density << speed;
}

// 0.1 mg at 2 kHz: off its centre, so that air turns and shifts it together.
void AirTest::grainsNeverGainSpeed() {
    QFETCH(double, density);
    QFETCH(double, speed);
    Mechanics scene;
    scene.airDensity = density;
    RigidBody grain = bodyAt(1, Vec3::Zero(), 1e-7, Vec3(1e-14, 3e-14, 2e-14));
    grain.velocity = speed * Vec3(1, 0.3, -0.5);
    grain.angularVelocity = Vec3(100, -300, 20);
    grain.centre = Vec3(1e-3, 0, 5e-4);
    scene.bodies = {grain};
    scene.colliders = {boxOn(1, Vec3(0.01, 0.002, 0.004))};
    Running run(scene);
    double before = kineticOf(run);
    for (int i = 0; i < 2000; ++i) {
        run.run(5e-4, 5e-4, Vec3::Zero());
        const double now = kineticOf(run);
        QVERIFY2(now <= before * (1 + 1e-12), qPrintable(QString::number(i)));
        before = now;
    }
    QVERIFY(std::isfinite(before));
    QCOMPARE_LT(run.bodies()[0].velocity.norm(),
                0.6 * speed); // as a vane that hardly turns it is slowed less
}

void AirTest::mechanismsNeverGainEnergy() {
    std::mt19937 random(5);
    const auto unit = [&] { return double(random()) / double(std::mt19937::max()); };
    for (int round = 0; round < 20; ++round) {
        Chain chain = chainOf(8, 0.01, 1e-4);
        Mechanics scene;
        scene.airDensity = std::pow(10, 3 * unit());
        scene.bodies = chain.bodies, scene.joints = chain.joints;
        for (const RigidBody& body : chain.bodies)
            scene.colliders.push_back(boxOn(body.id, Vec3(0.01, 0.004 + 0.01 * unit(), 0.003)));
        scene.bodies.back().velocity = Vec3(0, 1, 1);
        Running run(scene);
        double before = kineticOf(run);
        for (int i = 0; i < 400; ++i) {
            run.run(2e-4, 2e-4, Vec3::Zero());
            const double now = kineticOf(run);
            QVERIFY(now <= before * (1 + 1e-6)); // what the integrator itself may add
            before = now;
        }
    }
}

void AirTest::withoutAirThereIsNone() {
    QVERIFY(Running(plate(0.01, Quat::Identity(), 0)).mechanism().air.empty());
    Mechanics bare = plate(0.01, Quat::Identity());
    bare.colliders.clear();
    QVERIFY(Running(bare).mechanism().air.empty());
}

TACTUM_TEST(AirTest)

} // namespace test_air

#include "test_air.moc"
