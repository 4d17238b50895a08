// Moving, turning and scaling: what goes along, and that all of it goes as one rigid or grown thing does.
#include <cmath>
#include <numbers>

#include <QTest>

#include "core/dynamics/mechanism_build.h"
#include "core/motion/motion_build.h"
#include "core/scene/arrange.h"
#include "core/scene/bodies.h"
#include "core/scene/colliders.h"
#include "tests/core/scene/things.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_arrange {

using namespace tactum;
using namespace tactum::test;

namespace {

Arrangement someTurn() {
    Arrangement by;
    by.about = {0.1, -0.2, 0.3}, by.move = {0.01, 0.02, -0.03};
    by.turn = Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()));
    return by;
}

/// Where a corner of an object is in the world.
Vec3 cornerOf(const Scene& scene, ObjectId id, std::size_t corner = 0) {
    const SceneObject& object = *scene.find(id);
    return object.pose.apply(object.geometry->positions[corner]);
}

Pose placeOf(const Scene& scene, BodyId body) {
    const RigidBody* found = findBody(scene, body);
    return found ? found->pose : Pose{};
}

void arrangeAll(Scene& scene, std::initializer_list<ObjectId> ids, const Arrangement& by) {
    const std::vector<ObjectId> objects(ids);
    arrange(scene, goingAlong(scene, objects), by);
}

/// A wheel on the world, a rod on the wheel, a piston that slides in the world and hangs on the rod.
struct Crank {
    Scene scene;
    ObjectId base, wheel, rod, piston;
    BodyId wheelBody, rodBody, pistonBody;
    Crank() {
        base = add(scene, "base", box({0.18, 0.01, 0.06}, {0, -0.055, 0}));
        wheel = add(scene, "wheel", box({0.06, 0.06, 0.008}), {Quat::Identity(), {-0.05, 0, 0}});
        rod = add(scene, "rod", box({0.078, 0.006, 0.006}), {Quat::Identity(), {0.005, 0, 0.009}});
        piston = add(scene, "piston", box({0.03, 0.02, 0.006}), {Quat::Identity(), {0.045, 0, 0.016}});
        wheelBody = makeBody(scene, wheel), rodBody = makeBody(scene, rod),
        pistonBody = makeBody(scene, piston);
        join(wheelBody, kWorldBody, AxisKind::Hinge, {-0.05, 0, 0}, Vec3::UnitZ(), 0);
        join(rodBody, wheelBody, AxisKind::Hinge, {-0.03, 0, 0.009}, Vec3::UnitZ(), 0);
        join(pistonBody, kWorldBody, AxisKind::Slider, {0.045, 0, 0.016}, Vec3::UnitX(), 0);
        join(pistonBody, rodBody, AxisKind::Hinge, {0.04, 0, 0.009}, Vec3::UnitZ(), 1);
    }
    void join(BodyId body, BodyId to, AxisKind kind, const Vec3& at, const Vec3& axis, std::size_t which) {
        AxisJoint joint;
        joint.kind = kind, joint.to = to, joint.at = at, joint.axis = axis;
        joint.low = -0.01, joint.high = 0.02;
        setAxisJoint(scene, body, joint, which);
    }
    /// Of the two frames of each joint, m and as of quaternions.
    double gap() const {
        double most = 0;
        for (const Joint& joint : scene.mechanics.joints) {
            const Pose a = placeOf(scene, joint.a) * joint.frameA, b = placeOf(scene, joint.b) * joint.frameB;
            most = std::max(
                {most, (a.translation - b.translation).norm(), 1 - std::abs(a.rotation.dot(b.rotation))});
        }
        return most;
    }
};

} // namespace

class TestArrange : public QObject {
    Q_OBJECT

private slots:
    void pointsGoAboutThePivot() {
        Arrangement by;
        QVERIFY(by.changesNothing());
        by.about = {1, 0, 0}, by.scale = 2, by.move = {0, 0, 5};
        by.turn = Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()));
        QVERIFY(!by.changesNothing());
        COMPARE_NEAR(by.apply(Vec3(2, 0, 0)), Vec3(1, 2, 5), 1e-12, "m");
        COMPARE_NEAR(by.apply(Pose{}).translation, Vec3(1, -2, 5), 1e-12, "m");
    }

    void aStillThingTakesWhatBodiesMeetOfIt() {
        Doorway doorway;
        Scene& scene = doorway.scene;
        const ObjectId shelf = add(scene, "shelf", box({0.1, 0.01, 0.1}), {Quat::Identity(), {0, -0.1, 0}});
        const ObjectId ball = add(scene, "ball", box({0.01, 0.01, 0.01}), {Quat::Identity(), {0.2, 0, 0}});
        makeBody(scene, ball);
        const Scene before = scene;
        const auto of = collidersOf(scene, *scene.find(shelf));
        QCOMPARE(of.size(), std::size_t(1));
        const Arrangement by = someTurn();
        arrangeAll(scene, {shelf}, by);
        for (std::size_t i = 0; i < scene.mechanics.colliders.size(); ++i)
            if (i == of[0])
                COMPARE_NEAR(scene.mechanics.colliders[i].pose.translation,
                             by.apply(before.mechanics.colliders[i].pose.translation), 1e-12, "m");
            else
                QVERIFY(scene.mechanics.colliders[i] == before.mechanics.colliders[i]);
        COMPARE_NEAR(cornerOf(scene, shelf), by.apply(cornerOf(before, shelf)), 1e-12, "m");
        for (const ObjectId other : {doorway.post, doorway.door, ball})
            QVERIFY(*scene.find(other) == *before.find(other));
        // However it is met: a sphere around it is its collider, too.
        ColliderShape sphere;
        sphere.kind = ShapeKind::Sphere, sphere.radius = 0.07;
        scene.mechanics.colliders[of[0]].shape = sphere;
        QCOMPARE(collidersOf(scene, *scene.find(shelf)), of);
        // And so is what is much smaller, inside of it.
        ColliderShape small;
        small.kind = ShapeKind::Box, small.size = {0.02, 0.005, 0.02};
        scene.mechanics.colliders[of[0]].shape = small;
        QCOMPARE(collidersOf(scene, *scene.find(shelf)), of);
    }

    void aDoorTakesItsHingeAndAPostItsDoor() {
        Doorway doorway;
        Scene& scene = doorway.scene;
        const BodyId door = makeBody(scene, doorway.door);
        setAxisJoint(scene, door, guessedJoint(scene, door, AxisKind::Hinge));
        const AxisJoint hinge = *axisJointOf(scene, door);
        const Scene before = scene;
        const Arrangement by = someTurn();
        arrangeAll(scene, {doorway.door}, by);
        const AxisJoint moved = *axisJointOf(scene, door);
        COMPARE_NEAR(moved.at, by.apply(hinge.at), 1e-12, "m");
        COMPARE_NEAR(moved.axis, by.turn * hinge.axis, 1e-12, "");
        QVERIFY(*scene.find(doorway.post) == *before.find(doorway.post));
        scene = before;
        arrangeAll(scene, {doorway.post}, by);
        COMPARE_NEAR(axisJointOf(scene, door)->at, by.apply(hinge.at), 1e-12, "m");
        COMPARE_NEAR(cornerOf(scene, doorway.door, 5), by.apply(cornerOf(before, doorway.door, 5)), 1e-12,
                     "m");
    }

    // Whatever of a crank is taken, its joints stay closed.
    void aLoopStaysClosed() {
        const Crank crank;
        QCOMPARE_LT(crank.gap(), 1e-12);
        QCOMPARE(goingAlong(crank.scene, std::array{crank.wheel}).objects,
                 (std::vector{crank.wheel, crank.rod, crank.piston}));
        QCOMPARE(goingAlong(crank.scene, std::array{crank.base}).objects.size(), std::size_t(4));
        QCOMPARE(goingAlong(crank.scene, std::array{crank.piston}).objects, std::vector{crank.piston});
        for (const ObjectId taken : {crank.base, crank.wheel, crank.rod, crank.piston}) {
            Crank moved = crank;
            Arrangement by = someTurn();
            arrangeAll(moved.scene, {taken}, by);
            QCOMPARE_LT(moved.gap(), 1e-12);
            by.scale = 1.7;
            arrangeAll(moved.scene, {taken}, by);
            QCOMPARE_LT(moved.gap(), 1e-12);
            QVERIFY(compileMechanism(moved.scene.mechanics.bodies, moved.scene.mechanics.joints).has_value());
        }
    }

    // Twice as large: lengths and stops double, moments grow by four, the mass stays.
    void whatGrowsKeepsItsMass() {
        Crank crank;
        const Scene before = crank.scene;
        Arrangement by;
        by.about = {-0.05, 0, 0}, by.scale = 2;
        arrangeAll(crank.scene, {crank.wheel}, by);
        const RigidBody &rod = *findBody(crank.scene, crank.rodBody), &was = *findBody(before, crank.rodBody);
        QCOMPARE(rod.mass, was.mass);
        COMPARE_NEAR(rod.inertia, 4 * was.inertia, 1e-18, "kg m^2");
        COMPARE_NEAR(rod.pose.translation, by.apply(was.pose.translation), 1e-12, "m");
        const auto slide = axisJointOf(crank.scene, crank.pistonBody);
        COMPARE_NEAR(slide->high, 0.04, 1e-12, "m");
        COMPARE_NEAR(axisJointOf(crank.scene, crank.rodBody)->high, 0.02, 1e-12, "rad");
        for (std::size_t i = 0; i < before.mechanics.colliders.size(); ++i) {
            const Collider &now = crank.scene.mechanics.colliders[i], &then = before.mechanics.colliders[i];
            const double factor = then.body == kWorldBody ? 1 : 8;
            COMPARE_NEAR(massOf(now.shape).volume, factor * massOf(then.shape).volume, 1e-15, "m^3");
        }
        for (const ObjectId id : {crank.wheel, crank.rod, crank.piston})
            COMPARE_NEAR(cornerOf(crank.scene, id, 3), by.apply(cornerOf(before, id, 3)), 1e-12, "m");
        QVERIFY(*crank.scene.find(crank.base) == *before.find(crank.base));
    }

    // As what others meet it away from its frame, in motion, and on keys.
    void whatIsBesideTheFrameGoesAlong() {
        Scene scene;
        const ObjectId id = add(scene, "stone", box({0.02, 0.02, 0.02}, {0.05, 0, 0}));
        const BodyId body = makeBody(scene, id);
        setColliderForm(scene, id, ColliderForm::Box);
        findBody(scene, body)->velocity = {1, 0, 0};
        findBody(scene, body)->angularVelocity = {0, 2, 0};
        const ObjectId led = add(scene, "led", box({0.02, 0.02, 0.02}, {0, 0.2, 0}));
        Track<Vec3> way;
        way.times = {0, 1}, way.values = {Vec3::Zero(), {0.1, 0, 0}};
        scene.find(led)->motion = std::make_shared<const Motion>(makeMotion(way, {}, 1));
        Arrangement by = someTurn();
        by.scale = 3;
        const Collider before = scene.mechanics.colliders[0];
        const Pose started = scene.find(led)->pose;
        arrangeAll(scene, {id, led}, by);
        const RigidBody& now = *findBody(scene, body);
        COMPARE_NEAR(now.velocity, by.turn * Vec3(3, 0, 0), 1e-12, "m/s");
        COMPARE_NEAR(now.angularVelocity, by.turn * Vec3(0, 2, 0), 1e-12, "rad/s");
        COMPARE_NEAR((now.pose * scene.mechanics.colliders[0].pose).translation,
                     by.apply(before.pose.translation), 1e-12, "m");
        QCOMPARE_GT(before.pose.translation.norm(), 0.04); // else it is not beside
        COMPARE_NEAR((scene.find(led)->pose * scene.find(led)->motion->at(1)).translation,
                     by.apply((started * Pose{Quat::Identity(), {0.1, 0, 0}}).translation), 1e-12, "m");
    }

    // There and back again.
    void aTurnIsUndoneByItsOpposite() {
        Crank crank;
        const Scene before = crank.scene;
        Arrangement by = someTurn(), back;
        arrangeAll(crank.scene, {crank.wheel, crank.base}, by);
        back.about = by.about + by.move, back.move = -by.move, back.turn = by.turn.conjugate();
        arrangeAll(crank.scene, {crank.wheel, crank.base}, back);
        for (const SceneObject& object : before.objects)
            COMPARE_NEAR(cornerOf(crank.scene, object.id, 6), cornerOf(before, object.id, 6), 1e-12, "m");
        QCOMPARE_LT(crank.gap(), 1e-12);
    }

    // A car leaves its track where it is; a body that carries the track takes both along.
    void aPathStaysUnlessItIsCarried() {
        Crank crank;
        Scene& scene = crank.scene;
        Joint& joint = scene.mechanics.joints[0];
        joint.path.points = {{-0.1, 0, 0}, {0, 0.1, 0}, {0.1, 0, 0}};
        const Joint before = joint;
        Arrangement by;
        by.move = {0.01, 0, 0}, by.scale = 3;
        Scene moved = scene;
        arrangeAll(moved, {crank.wheel}, by);
        QVERIFY(moved.mechanics.joints[0].path == before.path);
        QVERIFY(moved.mechanics.joints[0].frameA == before.frameA);
        moved = scene;
        arrangeAll(moved, {crank.base}, by);
        const Joint& carried = moved.mechanics.joints[0];
        COMPARE_NEAR(carried.frameA.apply(carried.path.points[1]),
                     by.apply(before.frameA.apply(before.path.points[1])), 1e-12, "m");
    }
};

TACTUM_TEST(TestArrange)

} // namespace test_arrange

#include "test_arrange.moc"
