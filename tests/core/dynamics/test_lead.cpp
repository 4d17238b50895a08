// Bodies that are led, and what hangs on them.
//
// What would show that a test here is wrong: a pendulum on a pivot that speeds up evenly stands still at
// atan(a / g) beside it, and nowhere else; where a body is led to is given from outside.

#include <cmath>

#include <QTest>

#include "core/dynamics/lead.h"
#include "tests/core/dynamics/mechanisms.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_lead {

using namespace tactum;
using namespace tactum::test;

namespace {

RigidBody ledBody(const Pose& pose) {
    RigidBody body = bodyAt(1, Vec3::Zero());
    body.pose = pose;
    body.centre = Vec3(0.1, 0.2, -0.1); // the frame is led, not the centre
    body.inertiaFrame = Quat(Eigen::AngleAxisd(0.4, Vec3(1, 1, 0).normalized()));
    body.kinematic = true;
    return body;
}

/// Leads the body 0 along a course for some time.
template <class Course> void runLed(Running& run, double seconds, double dt, const Course& course) {
    Leader leader(run.mechanism());
    const int steps = int(std::lround(seconds / dt));
    for (int i = 1; i <= steps; ++i) {
        Leader::Led led{0, course(i * dt)};
        if (i % 2) led.to.rotation.coeffs() *= -1; // the same turn
        leader.lead({&led, 1}, dt, run.state());
        run.run(dt, dt);
    }
}

} // namespace

class LeadTest : public QObject {
    Q_OBJECT

private slots:
    void itGoesWhereItIsLed() {
        const Pose rest{Quat(Eigen::AngleAxisd(1, Vec3::UnitY())), Vec3(1, 2, 3)};
        Running run({ledBody(rest)}, {});
        const auto course = [&](double t) {
            return rest * Pose{Quat(Eigen::AngleAxisd(5 * t, Vec3(1, 2, 2) / 3)),
                               Vec3(std::sin(3 * t), t * t, 1 - std::cos(t))};
        };
        for (const double until : {0.5, 1.0, 2.0}) { // beyond half a turn and a whole one
            Running again({ledBody(rest)}, {});
            runLed(again, until, 1e-3, course);
            const Pose at = again.bodies()[0].pose, wanted = course(until);
            COMPARE_NEAR(at.translation, wanted.translation, 1e-9, "m");
            COMPARE_NEAR(at.rotation.angularDistance(wanted.rotation), 0, 1e-8, "rad");
            COMPARE_NEAR(again.bodies()[0].angularVelocity.norm(), 5, 1e-6, "rad/s");
        }
    }

    void whatHangsOnItFeelsItsAcceleration() {
        constexpr double kSpeedsUp = 4, kLength = 0.3; // m/s^2, m
        const double lean = std::atan2(kSpeedsUp, 9.81);
        std::vector<RigidBody> bodies{ledBody({}),
                                      bodyAt(2, kLength * Vec3(-std::sin(lean), -std::cos(lean), 0), 0.5)};
        Running run(bodies, {hingeAt(bodies, 1, 2, Vec3::Zero())});
        runLed(run, 2, 5e-4, [&](double t) {
            return Pose{Quat::Identity(), Vec3(0.5 * kSpeedsUp * t * t, 0, 0)};
        });
        const Vec3 arm = run.bodies()[1].centre - run.bodies()[0].pose.translation;
        COMPARE_NEAR(std::atan2(-arm.x(), -arm.y()), lean, 1e-3, "rad");
        COMPARE_NEAR(run.bodies()[1].velocity.x(), 2 * kSpeedsUp, 0.01, "m/s");
    }

    void whatIsPutThereStands() {
        Running run({ledBody({})}, {});
        const Pose there{Quat(Eigen::AngleAxisd(2, Vec3::UnitX())), Vec3(5, 0, 0)};
        run.state().v.setConstant(3); // however it moved before
        Leader(run.mechanism()).put({0, there}, run.state());
        run.run(0.1, 1e-3);
        COMPARE_NEAR(run.bodies()[0].pose.translation, there.translation, 1e-12, "m");
        COMPARE_NEAR(run.bodies()[0].pose.rotation.angularDistance(there.rotation), 0, 1e-7, "rad");
    }

    void whoCanBeLed() {
        std::vector<RigidBody> bodies{ledBody({}), bodyAt(2, Vec3(1, 0, 0)), bodyAt(3, Vec3(2, 0, 0))};
        bodies[2].kinematic = true;
        const Mechanism mechanism =
            compileMechanism(bodies, std::vector{hingeAt(bodies, kWorldBody, 3, Vec3(2, 0, 0))}).value();
        const Leader leader(mechanism);
        QCOMPARE(leader.canLead(0), true);
        QCOMPARE(leader.canLead(1), false); // forces move it
        QCOMPARE(leader.canLead(2), false); // its hinge holds it
        bodies[1].inertia.setZero();
        const Mechanism pushed = compileMechanism(std::vector{bodies[1]}, {}).value();
        QCOMPARE(Leader(pushed).canLead(0), false); // forces move it, though they do not turn it
    }
};

TACTUM_TEST(LeadTest)

} // namespace test_lead

#include "test_lead.moc"
