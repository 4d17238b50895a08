// What bodies meet, as it is drawn: every line lies on the shape itself, wherever body and object are.
#include <algorithm>
#include <cmath>

#include <QTest>

#include "core/scene/bodies.h"
#include "core/scene/colliders.h"
#include "tests/core/scene/things.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "ui/view/collider_marks.h"

namespace test_collider_marks {

using namespace tactum;
using namespace tactum::test;

class TestColliderMarks : public QObject {
    Q_OBJECT

private slots:
    // distanceTo() is 0 on a shape and inside of it, and grows at once outside of one a millimetre smaller. A
    // hull counts as its box there, and is left out.
    void theyLieOnWhatBodiesMeet() {
        for (const ColliderForm form :
             {ColliderForm::Box, ColliderForm::Sphere, ColliderForm::Capsule, ColliderForm::Cylinder}) {
            Scene scene;
            const Pose place{Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized())), {0.3, -0.1, 0.2}};
            const ObjectId id = add(scene, "rod", box({0.03, 0.1, 0.04}, {0.01, 0, 0}), place);
            const BodyId body = makeBody(scene, id);
            // A body whose frame is not that of its object.
            const Pose turn{Quat(Eigen::AngleAxisd(-0.4, Vec3::UnitZ())), {0.02, 0.03, 0}};
            findBody(scene, body)->pose = findBody(scene, body)->pose * turn;
            for (Collider& each : scene.mechanics.colliders)
                each.pose = turn.inverse() * each.pose;
            setColliderForm(scene, id, form);
            const auto marks = colliderMarks(scene);
            QCOMPARE(marks.size(), std::size_t(1));
            QCOMPARE(marks[0].carrier, id);
            const Collider& collider = scene.mechanics.colliders[0];
            const Pose toShape =
                (findBody(scene, body)->pose * collider.pose).inverse() * scene.find(id)->pose;
            ColliderShape smaller = collider.shape;
            smaller.size -= Vec3::Constant(2e-3);
            smaller.radius -= 1e-3, smaller.radiusBottom -= 1e-3;
            if (form == ColliderForm::Cylinder) smaller.height -= 2e-3;
            std::size_t points = 0;
            Bounds drawn;
            for (const auto& line : marks[0].lines)
                for (const Vec3& p : line) {
                    COMPARE_NEAR(distanceTo(collider.shape, toShape.apply(p)), 0, 1e-9, "m");
                    QCOMPARE_GT(distanceTo(smaller, toShape.apply(p)), 0.9e-3);
                    drawn.add(p);
                    ++points;
                }
            QCOMPARE_GE(points, std::size_t(24)); // twelve edges of a box
            // And around the object.
            const Bounds own = boundsOf(*scene.find(id)->geometry);
            QVERIFY((drawn.high - drawn.low).minCoeff() > 0.9 * (own.high - own.low).minCoeff());
            COMPARE_NEAR(drawn.centre(), own.centre(), 1e-3, "m");
        }
    }
};

TACTUM_TEST(TestColliderMarks)

} // namespace test_collider_marks

#include "test_collider_marks.moc"
