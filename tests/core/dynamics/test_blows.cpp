// Blows that several places of bodies meet at once: against e v, momentum and symmetry.
//
// What would show that a test here is wrong: one ball, which has one place, bounces by the same formula
// (test_contacts), and the elastic pairs conserve energy whatever the formula of the blow.
#include <array>
#include <numbers>
#include <random>

#include <QTest>

#include "tests/core/dynamics/loose.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_blows {

using namespace tactum;
using namespace tactum::test;

namespace {

const Quat kLying(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX()));

TouchMaterial bouncing(double friction, double restitution) {
    return {friction, friction, restitution, Combine::Average, Combine::Average};
}

} // namespace

class TestBlows : public QObject {
    Q_OBJECT

private slots:
    void whatFallsFlatBouncesAsAWhole_data() {
        QTest::addColumn<int>("shape");
        QTest::addColumn<double>("restitution");
        QTest::addColumn<double>("friction");
        const char* const names[]{"box", "lying cylinder", "standing cylinder", "lying capsule"};
        for (int shape = 0; shape < 4; ++shape)
            for (const double restitution : {0.0, 0.3, 0.8, 1.0})
                for (const double friction : {0.0, 0.5})
                    QTest::addRow("%s, %g, mu %g", names[shape], restitution, friction)
                        << shape << restitution << friction;
    }

    /// Of v it keeps e v, and does not turn.
    void whatFallsFlatBouncesAsAWhole() {
        QFETCH(int, shape);
        QFETCH(double, restitution);
        QFETCH(double, friction);
        const std::array<ColliderShape, 4> shapes{
            box({0.1, 0.1, 0.1}), lengthwise(ShapeKind::Cylinder, 0.05, 0.2),
            lengthwise(ShapeKind::Cylinder, 0.05, 0.1), lengthwise(ShapeKind::Capsule, 0.05, 0.1)};
        World world;
        world.material = bouncing(friction, restitution);
        world.addStill(floorShape());
        const double height = 0.2, speed = std::sqrt(2 * 9.81 * height), before = 0.95 * speed / 9.81;
        const bool lies = shape == 1 || shape == 3;
        world.add(shapes[std::size_t(shape)], {lies ? kLying : Quat::Identity(), Vec3(0, 0.05 + height, 0)},
                  1);
        Running run(world.mechanics);
        run.run(before, 1e-3);
        double fastest = -1, turns = 0;
        for (int i = 0; i < 50; ++i) {
            run.run(1e-3, 1e-3);
            fastest = std::max(fastest, run.bodies()[0].velocity.y());
            turns = std::max(turns, run.bodies()[0].angularVelocity.norm());
        }
        COMPARE_NEAR(fastest, restitution * speed, 0.011, "m/s"); // a step of the fall
        COMPARE_NEAR(turns, 0, 1e-6, "rad/s");
    }

    /// Side by side and end on end: momentum and energy say where both go.
    void cylindersMeetHeadOn_data() {
        QTest::addColumn<bool>("side");
        QTest::newRow("side by side") << true;
        QTest::newRow("end on end") << false;
    }
    void cylindersMeetHeadOn() {
        QFETCH(bool, side);
        World world;
        world.material = bouncing(0, 1);
        const ColliderShape shape = lengthwise(ShapeKind::Cylinder, 0.05, 0.2);
        const Vec3 way = side ? Vec3::UnitX() : Vec3::UnitY();
        world.add(shape, {}, 2).velocity = 20 * way;
        world.add(shape, {Quat::Identity(), 0.3 * way}, 1);
        Running run(world.mechanics);
        run.run(0.1, 1e-3, Vec3::Zero());
        COMPARE_NEAR(run.bodies()[0].velocity, Vec3(20. / 3 * way), 1e-9, "m/s");
        COMPARE_NEAR(run.bodies()[1].velocity, Vec3(80. / 3 * way), 1e-9, "m/s");
        COMPARE_NEAR(run.bodies()[0].angularVelocity.norm(), 0, 1e-9, "rad/s");
    }

    /// Both sides of a groove are struck together: a ball goes straight up again, or stays.
    void aBallInAGrooveGoesToNeitherSide_data() {
        QTest::addColumn<double>("restitution");
        QTest::newRow("0") << 0.;
        QTest::newRow("0.5") << 0.5;
        QTest::newRow("1") << 1.;
    }
    void aBallInAGrooveGoesToNeitherSide() {
        QFETCH(double, restitution);
        World world;
        world.material = bouncing(0, restitution);
        const double radius = 0.05;
        for (const double x : {-radius, radius})
            world.addStill(lengthwise(ShapeKind::Cylinder, radius, 1), {kLying, Vec3(x, 0, 0)});
        world.add(ball(radius), at(0, 0.2), 1);
        Running run(world.mechanics);
        double fastest = -1;
        for (int i = 0; i < 500; ++i) {
            run.run(1e-3, 1e-3);
            fastest = std::max(fastest, run.bodies()[0].velocity.y());
            COMPARE_NEAR(run.bodies()[0].velocity.x(), 0, 1e-6, "m/s");
        }
        const double fall = 0.2 - std::sqrt(3.0) * radius;
        COMPARE_NEAR(fastest, restitution * std::sqrt(2 * 9.81 * fall), 0.011, "m/s");
    }

    /// Rods that fly into each other at random, without friction: each blow is elastic. At 300 rad/s what
    /// touched as it rolled points elsewhere within half a step, and must not push what leaves.
    void elasticRodsKeepTheirEnergy() {
        std::mt19937 random(5);
        const auto number = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
        };
        const auto turned = [&] {
            return Quat(Eigen::Vector4d(number(-1, 1), number(-1, 1), number(-1, 1), 1.1).normalized());
        };
        int met = 0;
        double worst = 0;
        for (int trial = 0; trial < 300; ++trial) {
            World world;
            world.material = bouncing(0, 1);
            const auto kind = [&] { return random() % 2 ? ShapeKind::Capsule : ShapeKind::Cylinder; };
            const auto rod = [&] { return lengthwise(kind(), number(0.005, 0.01), number(0.01, 0.03)); };
            world.add(rod(), {turned(), Vec3::Zero()}, number(0.01, 0.05));
            world.add(rod(), {turned(), Vec3(0.06, number(-0.01, 0.01), number(-0.01, 0.01))}, 0.05)
                .velocity = Vec3(number(-8, -2), 0, 0);
            Running run(world.mechanics);
            const double energy = run.energy(Vec3::Zero());
            run.run(0.03, 5e-4, Vec3::Zero());
            met += run.bodies(Vec3::Zero())[0].velocity.norm() > 0.01;
            worst = std::max(worst, std::abs(run.energy(Vec3::Zero()) / energy - 1));
        }
        qInfo("%d met, at most %.2f %% off", met, 100 * worst);
        QCOMPARE_GT(met, 100);
        QCOMPARE_LT(worst, 0.01); // it was 0.13
    }
};

TACTUM_TEST(TestBlows)

} // namespace test_blows

#include "test_blows.moc"
