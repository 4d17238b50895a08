// The proof that a step of bodies and joints neither allocates nor locks: no hit of the interposer.
#include <cmath>

#include <QTest>

#include "core/base/realtime.h"
#include "core/haptics/haptic_step.h"
#include "tests/core/dynamics/mechanisms.h"
#include "tests/realtime/interposer.h"
#include "tests/support/hand.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"
#include "tests/support/two_hands.h"

namespace test_dynamics_realtime {

using namespace tactum;
using namespace tactum::test;

class TestDynamicsRealtime : public QObject {
    Q_OBJECT

private slots:
    // A chain with limits, friction and motors, a loop, and boxes and balls that fall on the floor.
    void tenThousandSteps() {
        Chain chain = chainOf(6);
        Mechanics scene{chain.bodies, chain.joints, {}, kDown};
        scene.joints[1].limits.push_back({true, 1, -0.3, 0.4});
        scene.joints[2].frictions.push_back({true, 0, 0.001});
        scene.joints[3].drives.push_back({.angular = true, .axis = 0, .stiffness = 1e6, .damping = 10});
        scene.joints.push_back(ballAt(scene.bodies, kWorldBody, 6, Vec3(0.6, 0, 0)));
        ColliderShape floor;
        floor.kind = ShapeKind::Plane;
        floor.size = {kUnbounded, 0, kUnbounded};
        scene.colliders.push_back({kWorldBody, {Quat::Identity(), Vec3(0, -0.5, 0)}, floor, {}, {}});
        for (int i = 0; i < 8; ++i) {
            const BodyId id = BodyId(100 + i);
            scene.bodies.push_back(bodyAt(id, Vec3(0.02 * i, -0.3 + 0.12 * i, 2), 0.2, Vec3::Constant(1e-4)));
            ColliderShape shape;
            shape.kind = i % 2 ? ShapeKind::Sphere : ShapeKind::Box;
            shape.radius = 0.04;
            shape.size = Vec3::Constant(0.08);
            scene.colliders.push_back(
                {id, Pose{}, shape, {0.5, 0.4, 0.3, Combine::Average, Combine::Average}, {}});
        }
        Running run(scene);
        run.run(0.01, 1e-3);
        int allocated = 0;
        interposer::reset();
        for (int i = 0; i < 10'000; ++i) {
            const RealtimeScope scope;
            run.dynamics().step(run.state(), kDown, {}, 1e-3);
            allocated += interposer::hits() > 0;
        }
        QVERIFY2(interposer::hits() == 0, interposer::firstHit().c_str());
        QCOMPARE(allocated, 0);
        QVERIFY(run.state().q.allFinite());
    }

    // The same in the hand: a plate that is pressed onto a floor, dragged, and let go.
    void tenThousandHapticStepsOfAPushedPlate() {
        Material feel;
        feel.staticFriction = feel.dynamicFriction = 0.4;
        Scene scene = sceneOf(plate(0.05, 0.01), feel, 1e-3, {Quat::Identity(), {0, 0, -0.005}});
        scene.mechanics.gravity = {0, 0, -9.81};
        scene.mechanics.bodies = {bodyAt(1, Vec3(0, 0, -0.005), 0.1, Vec3::Constant(1e-4))};
        scene.objects[0].body = 1;
        ColliderShape box, floor;
        box.size = {0.1, 0.1, 0.01};
        floor.kind = ShapeKind::Plane;
        floor.size = {kUnbounded, 0, kUnbounded};
        const Quat up(Eigen::AngleAxisd(EIGEN_PI / 2, Vec3::UnitX()));
        scene.mechanics.colliders = {{1, Pose{}, box, {0.1, 0.1}, {}},
                                     {kWorldBody, {up, Vec3(0, 0, -0.01)}, floor, {0.1, 0.1}, {}}};
        const auto world = compile(scene).value();
        SimState state;
        int touching = 0;
        interposer::reset();
        for (int i = 0; i < 10'000; ++i) {
            const double t = 5e-4 * i;
            const Vec3 finger(0.01 * std::sin(3 * t), 0, 2e-3 * std::cos(7 * t));
            const RealtimeScope scope;
            touching += hapticStep(*world, state, {.finger = finger}, 5e-4).contacts > 0;
        }
        QVERIFY2(interposer::hits() == 0, interposer::firstHit().c_str());
        QCOMPARE_GT(touching, 3000);
        QVERIFY2(std::abs(state.bodies.q[0]) > 1e-4, "it was not dragged");
    }

    // Two that take a box off its floor, turn it to and fro and let it go.
    void tenThousandHapticStepsOfTwoHands() {
        const auto world = compile(boxOnFloor(0.05, rough(0.9, 0.6))).value();
        TwoHands hands(world);
        const auto fingers = [](double depth, double y, double z) {
            const double x = kBoxHalf + kFingertip - depth;
            return std::array{Vec3(-x, y, z), Vec3(x, y, -z)};
        };
        int held = 0;
        interposer::reset();
        for (int i = 0; i < 10'000; ++i) {
            const double t = 1e-3 * i;
            const auto at = fingers(2e-3 * std::sin(2 * t), 0.01 * std::max(0.0, std::sin(2 * t)),
                                    2e-3 * std::sin(11 * t));
            const RealtimeScope scope;
            hands.to(at, {kAnswersLate, kAnswersLate});
            held += hands.box().y() > 1e-3;
        }
        QVERIFY2(interposer::hits() == 0, interposer::firstHit().c_str());
        QCOMPARE_GT(held, 2000);
    }
};

TACTUM_TEST(TestDynamicsRealtime)

} // namespace test_dynamics_realtime

#include "test_dynamics_realtime.moc"
