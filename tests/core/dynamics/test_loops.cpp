// Closed loops: a crank with its piston, a parallelogram, a loop of hinges in space.
//
// What would show that a test here is wrong: the piston's place is that of the crank's angle by Pythagoras,
// the parallelogram swings like one pendulum, both without any multiplier; a loop that is not closed makes
// its gap as large as the links.

#include <cmath>

#include <QTest>

#include "tests/core/dynamics/mechanisms.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_loops {

using namespace tactum;
using namespace tactum::test;

namespace {

struct Crank {
    double arm = 0.05, rod = 0.15;
    std::vector<RigidBody> bodies;
    std::vector<Joint> joints;

    /// At right angles to the piston's way, and turning.
    explicit Crank(double speed) {
        const double reach = std::sqrt(rod * rod - arm * arm);
        const Vec3 pin(0, arm, 0), piston(reach, 0, 0);
        const Quat lean = turnOnto(Vec3::UnitX(), (piston - pin).normalized());
        bodies = {bodyAt(1, 0.5 * pin, 0.4, Vec3(1e-4, 1e-4, 2e-4)),
                  bodyAt(2, 0.5 * (pin + piston), 0.2, Vec3(1e-5, 4e-4, 4e-4)),
                  bodyAt(3, piston, 0.3, Vec3::Constant(1e-4))};
        bodies[1].pose.rotation = lean;
        joints = {hingeAt(bodies, kWorldBody, 1, Vec3::Zero()), hingeAt(bodies, 1, 2, pin),
                  hingeAt(bodies, 2, 3, piston), sliderAt(bodies, kWorldBody, 3, piston, Vec3::UnitX())};
        // The rod goes along at that moment: its pins both move by the same.
        bodies[0].angularVelocity = Vec3(0, 0, speed);
        bodies[0].velocity = bodies[0].angularVelocity.cross(bodies[0].pose.translation);
        bodies[1].velocity = bodies[2].velocity = bodies[0].angularVelocity.cross(pin);
    }
};

} // namespace

class LoopsTest : public QObject {
    Q_OBJECT

private slots:
    void aCrankKeepsItsPistonAndItsEnergy();
    void aParallelogramSwingsAsOne();
    void aLoopThatStartsApartCloses();
    void anOpenLoopIsClosedWithoutSpeed();
    void aLoopInSpaceOfFourHingesStaysClosed();
};

void LoopsTest::aCrankKeepsItsPistonAndItsEnergy() {
    const Crank crank(20);
    Running run(crank.bodies, crank.joints);
    QCOMPARE(run.mechanism().vs, 3);
    QCOMPARE(run.mechanism().loopJoints, std::size_t(1));
    const double first = run.energy(Vec3::Zero());
    double gap = 0, off = 0;
    for (int i = 0; i < 10000; ++i) {
        run.run(1e-3, 1e-3, Vec3::Zero());
        gap = std::max(gap, run.dynamics().loopGap(run.state()));
        const auto& bodies = run.bodies(Vec3::Zero());
        const Vec3 pin = 2 * bodies[0].centre;
        const double wanted = pin.x() + std::sqrt(crank.rod * crank.rod - pin.y() * pin.y());
        off = std::max(off, (bodies[2].centre - Vec3(wanted, 0, 0)).norm());
    }
    COMPARE_NEAR(gap, 0, 1e-6, "m");
    COMPARE_NEAR(off, 0, 1e-6, "m");
    COMPARE_NEAR(run.energy(Vec3::Zero()) / first, 1, 2e-5, "");
}

void LoopsTest::aParallelogramSwingsAsOne() {
    // Two equal arms carry a bar: the bar does not turn, so the whole is a pendulum.
    const double arm = 0.2, half = 0.1;
    const Vec3 down = arm * Vec3(std::sin(0.6), -std::cos(0.6), 0);
    const double thin = 1e-9;
    std::vector<RigidBody> bodies{bodyAt(1, Vec3(-half, 0, 0) + 0.5 * down, thin, Vec3::Constant(thin)),
                                  bodyAt(2, Vec3(half, 0, 0) + 0.5 * down, thin, Vec3::Constant(thin)),
                                  bodyAt(3, down, 0.5, Vec3::Constant(1e-3))};
    Running run(bodies, {hingeAt(bodies, kWorldBody, 1, Vec3(-half, 0, 0)),
                         hingeAt(bodies, kWorldBody, 2, Vec3(half, 0, 0)),
                         hingeAt(bodies, 1, 3, Vec3(-half, 0, 0) + down),
                         hingeAt(bodies, 2, 3, Vec3(half, 0, 0) + down)});
    RigidBody point = bodyAt(1, down, 0.5, Vec3::Constant(1e-12));
    const std::vector<RigidBody> alone{point};
    Running pendulum(alone, {hingeAt(alone, kWorldBody, 1, Vec3::Zero())});
    run.run(2, 1e-3);
    pendulum.run(2, 1e-3);
    COMPARE_NEAR(run.bodies()[2].centre, pendulum.bodies()[0].centre, 1e-6, "m");
    COMPARE_NEAR(run.bodies()[2].pose.rotation.angularDistance(Quat::Identity()), 0, 1e-7, "rad");
}

void LoopsTest::aLoopThatStartsApartCloses() {
    std::vector<RigidBody> bodies{bodyAt(1, Vec3(0.1, 0, 0)), bodyAt(2, Vec3(0.3, 0.02, 0))};
    Joint ball = ballAt(bodies, 1, 2, Vec3(0.2, 0, 0));
    ball.frameB.translation += Vec3(0.01, -0.02, 0.005);
    Running run(bodies, {ball});
    run.run(0.5, 1e-3, Vec3::Zero());
    COMPARE_NEAR(run.dynamics().loopGap(run.state()), 0, 1e-9, "m");
    const auto& now = run.bodies(Vec3::Zero());
    COMPARE_NEAR(Vec3(now[0].velocity + now[1].velocity), Vec3::Zero(), 1e-12, "m/s");
}

// What a rough step has left open is not left to come back by itself, and does not throw what it closes.
void LoopsTest::anOpenLoopIsClosedWithoutSpeed() {
    const Crank crank(0);
    Running run(crank.bodies, crank.joints);
    run.state().q[1] += 1e-3;
    QCOMPARE_GT(run.dynamics().loopGap(run.state()), 1e-4);
    run.run(2e-3, 1e-3, Vec3::Zero());
    QCOMPARE_LT(run.dynamics().loopGap(run.state()), 1e-6);
    QCOMPARE_LT(run.energy(Vec3::Zero()), 1e-9);
}

// Bennett's linkage: four hinges in space, mobile although five times four locks hold four times six
// freedoms.
void LoopsTest::aLoopInSpaceOfFourHingesStaysClosed() {
    const double a = 0.2; // of equal links sin(twist) / length is the same for all four
    // Axes at the corners of a skew quadrilateral that is symmetric about z.
    const double h = a * std::sin(0.5) / 2, w = a * std::cos(0.5);
    const std::array<Vec3, 4> corner{Vec3(w / std::sqrt(2.), 0, h), Vec3(0, w / std::sqrt(2.), -h),
                                     Vec3(-w / std::sqrt(2.), 0, h), Vec3(0, -w / std::sqrt(2.), -h)};
    std::vector<RigidBody> bodies;
    for (std::size_t i = 0; i + 1 < 4; ++i)
        bodies.push_back(bodyAt(BodyId(i + 1), 0.5 * (corner[i] + corner[i + 1]), 0.2, Vec3::Constant(1e-3)));
    std::array<Vec3, 4> axis;
    for (std::size_t i = 0; i < 4; ++i) // at right angles to both links that meet there
        axis[i] = (corner[(i + 1) % 4] - corner[i]).cross(corner[(i + 3) % 4] - corner[i]).normalized();
    Running run(bodies, {hingeAt(bodies, kWorldBody, 1, corner[0], axis[0]),
                         hingeAt(bodies, 1, 2, corner[1], axis[1]), hingeAt(bodies, 2, 3, corner[2], axis[2]),
                         hingeAt(bodies, 3, kWorldBody, corner[3], axis[3])});
    const Vec3 before = run.bodies()[1].centre;
    const double first = run.energy();
    double gap = 0;
    for (int i = 0; i < 400; ++i) { // until it lies flat, where it may go on in two ways
        run.run(1e-3, 1e-3);
        gap = std::max(gap, run.dynamics().loopGap(run.state()));
    }
    QVERIFY((run.bodies()[1].centre - before).norm() > 0.01); // it does move
    COMPARE_NEAR(gap, 0, 1e-6, "m");
    COMPARE_NEAR(run.energy(), first, 1e-7, "J");
}

TACTUM_TEST(LoopsTest)

} // namespace test_loops

#include "test_loops.moc"
