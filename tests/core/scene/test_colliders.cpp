// As what objects meet each other: every form holds all points, none more than it must, and can be read
// again.
#include <cmath>
#include <numbers>

#include <QTest>

#include "core/scene/arrange.h"
#include "core/scene/bodies.h"
#include "core/scene/colliders.h"
#include "core/scene/mechanics_bytes.h"
#include "tests/core/scene/things.h"
#include "tests/support/compare.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"

namespace test_colliders {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double pi = std::numbers::pi;

/// A rod of 12 sides along an axis.
TriangleSoup rod(double radius, double length, int axis) {
    TriangleSoup soup;
    for (int i = 0; i < 12; ++i)
        for (const double end : {-0.5, 0.5}) {
            Vec3 p = Vec3::Zero();
            p[axis] = end * length;
            p[(axis + 1) % 3] = radius * std::cos(pi * i / 6),
                           p[(axis + 2) % 3] = radius * std::sin(pi * i / 6);
            soup.positions.push_back(p);
        }
    for (Index i = 0; i < 24; ++i)
        soup.triangles.push_back({i, (i + 1) % 24, (i + 2) % 24});
    soup.surfaceOf.assign(24, 0);
    return soup;
}

} // namespace

class TestColliders : public QObject {
    Q_OBJECT

    static void check(const TriangleSoup& soup, int axis, const ColliderShape& shape, const Pose& pose) {
        for (const Vec3& p : soup.positions)
            COMPARE_NEAR(distanceTo(shape, pose.applyInverse(p)), 0, 1e-9, "m");
        if (shape.kind == ShapeKind::Capsule || shape.kind == ShapeKind::Cylinder)
            COMPARE_NEAR(std::abs(pose.rotate(Vec3::UnitY())[axis]), 1, 1e-12, "");
    }

private slots:
    // Of a rod: the closed forms of what lies around it.
    void formsLieAroundTheirPoints() {
        for (int axis = 0; axis < 3; ++axis) {
            const TriangleSoup soup = rod(0.01, 0.1, axis);
            const auto around = [&](ColliderForm form) {
                Pose pose;
                ColliderShape shape = shapeAround(soup.positions, form, pose);
                check(soup, axis, shape, pose);
                return shape;
            };
            const ColliderShape ball = around(ColliderForm::Sphere);
            COMPARE_NEAR(ball.radius, std::hypot(0.05, 0.01), 1e-9, "m");
            const ColliderShape cylinder = around(ColliderForm::Cylinder);
            COMPARE_NEAR(cylinder.radius, 0.01, 1e-9, "m");
            COMPARE_NEAR(cylinder.height, 0.1, 1e-9, "m");
            const ColliderShape capsule = around(ColliderForm::Capsule);
            COMPARE_NEAR(capsule.radius, 0.01, 1e-9, "m");
            COMPARE_NEAR(capsule.height, 0.1, 1e-9, "m"); // its rims lie where the caps begin
            COMPARE_NEAR(around(ColliderForm::Box).size[axis], 0.1, 1e-9, "m");
            QCOMPARE(int(around(ColliderForm::Hull).kind), int(ShapeKind::Hull));
        }
    }

    // What tapers is met by round ends: around an octahedron of 20 mm they leave nothing between them.
    void capsAreTakenOffTheLength() {
        std::vector<Vec3> points;
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-0.01, 0.01})
                points.push_back(side * Vec3::Unit(axis));
        Pose pose;
        const ColliderShape capsule = shapeAround(points, ColliderForm::Capsule, pose);
        COMPARE_NEAR(capsule.radius, 0.01, 1e-12, "m");
        COMPARE_NEAR(capsule.height, 0, 1e-12, "m");
    }

    // What a body is met as is read back, and its mass stays; the still world's can be changed, too.
    void aFormIsReadAsItWasSet() {
        Doorway doorway;
        Scene& scene = doorway.scene;
        const BodyId body = makeBody(scene, doorway.door);
        const RigidBody before = *findBody(scene, body);
        QCOMPARE(int(colliderFormOf(scene, doorway.door).value()), int(ColliderForm::Hull));
        for (const ObjectId id : {doorway.door, doorway.post})
            for (const ColliderFormName& each : kColliderForms) {
                const auto part = scene.mechanics.colliders[collidersOf(scene, *scene.find(id))[0]].part;
                setColliderForm(scene, id, each.form);
                const bool one = each.form == ColliderForm::Parts; // of one part: its hull
                QCOMPARE(int(colliderFormOf(scene, id).value()), int(one ? ColliderForm::Hull : each.form));
                QCOMPARE(scene.mechanics.colliders.size(), std::size_t(2));
                QCOMPARE(scene.mechanics.colliders[collidersOf(scene, *scene.find(id))[0]].part, part);
            }
        QVERIFY(*findBody(scene, body) == before);
    }

    void partsAreOneColliderEach() {
        Scene scene;
        const ObjectId id = add(scene, "two", both(box({0.1, 0.1, 0.1}), box({0.1, 0.1, 0.1}, {0.3, 0, 0})));
        makeBody(scene, id);
        scene.mechanics.colliders[1].material.restitution = 0.5;
        scene.mechanics.colliders[0].material.restitution = 0.5;
        QCOMPARE(int(colliderFormOf(scene, id).value()), int(ColliderForm::Parts));
        setColliderForm(scene, id, ColliderForm::Box);
        QCOMPARE(scene.mechanics.colliders.size(), std::size_t(1));
        COMPARE_NEAR(scene.mechanics.colliders[0].shape.size, Vec3(0.4, 0.1, 0.1), 1e-12, "m");
        COMPARE_NEAR(scene.mechanics.colliders[0].pose.translation, Vec3(0.15, 0, 0), 1e-12, "m");
        setColliderForm(scene, id, ColliderForm::Parts);
        QCOMPARE(scene.mechanics.colliders.size(), std::size_t(2));
        QCOMPARE(scene.mechanics.colliders[1].material.restitution, 0.5);
    }
};

TACTUM_TEST(TestColliders)

} // namespace test_colliders

#include "test_colliders.moc"
