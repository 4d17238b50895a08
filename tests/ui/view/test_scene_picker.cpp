#include <QElapsedTimer>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/ui/view/ball_scene.h"
#include "ui/view/scene_picker.h"

namespace test_scene_picker {

using namespace tactum;
using namespace tactum::testing;

namespace {

std::optional<PickHit> cast(const Scene& scene, const Vec3& from, const Vec3& toward) {
    ScenePicker picker;
    picker.setScene(scene);
    return picker.cast({from, toward.normalized()}, ScenePicker::Patience::Wait);
}

} // namespace

class TestScenePicker : public QObject {
    Q_OBJECT
private slots:
    void findsTheNearSideAndItsSurface() {
        const Scene scene = ballScene(256, 128);
        const auto upper = cast(scene, {0, 0.02, 1}, -Vec3::UnitZ());
        const auto lower = cast(scene, {0, -0.02, 1}, -Vec3::UnitZ());
        QVERIFY(upper);
        QVERIFY(upper->surface == (SurfaceRef{scene.objects[0].id, kUpper}));
        QVERIFY(lower);
        QVERIFY(lower->surface == (SurfaceRef{scene.objects[0].id, kLower}));
        COMPARE_NEAR(upper->point.norm(), kBallRadius, 1e-4 * kBallRadius + 2e-5, "m");
        QCOMPARE_GT(upper->point.z(), 0);
        COMPARE_NEAR(upper->distance, 1 - upper->point.z(), 1e-9, "m");
    }

    void missesWhatIsNotThere() { QVERIFY(!cast(ballScene(), {0.06, 0, 1}, -Vec3::UnitZ())); }

    void theNearestObjectWins() {
        Scene scene = ballScene();
        SceneObject front = scene.objects[0];
        front.pose.translation = {0, 0, 0.2};
        const ObjectId id = scene.add(front).id;
        QCOMPARE(cast(scene, {0, 0.02, 1}, -Vec3::UnitZ())->surface.object, id);
        QCOMPARE(cast(scene, {0, 0.02, -1}, Vec3::UnitZ())->surface.object, scene.objects[0].id);
    }

    void aTurnedObjectIsHitWhereItIs() {
        Scene scene = ballScene();
        scene.objects[0].pose = {Quat(Eigen::AngleAxisd(EIGEN_PI, Vec3::UnitX())), {0.3, 0, 0}};
        const auto hit = cast(scene, {0.3, 0.02, 1}, -Vec3::UnitZ());
        QVERIFY(hit);
        QCOMPARE_EQ(hit->surface.surface, kLower); // upside down
    }

    void whatIsHiddenIsNotHit() {
        Scene scene = ballScene();
        scene.objects[0].visible = false;
        QVERIFY(!cast(scene, {0, 0, 1}, -Vec3::UnitZ()));
    }

    // A plane across z at 10 mm: the front of the ball is away, and a ray meets its back from inside.
    void whatASectionCutsAwayIsNotHit() {
        ScenePicker picker;
        picker.setScene(ballScene(256, 128));
        SectionPlane plane{{Quat::Identity(), {0, 0, 0.01}}};
        picker.setSection(plane);
        const auto front = [&](const Vec3& from, const Vec3& toward) {
            return picker.cast({from, toward}, ScenePicker::Patience::Wait);
        };
        const auto inside = front({0, 0.02, 1}, -Vec3::UnitZ());
        QVERIFY(inside);
        COMPARE_NEAR(inside->point.z(), -std::sqrt(0.05 * 0.05 - 0.02 * 0.02), 1e-4, "m");
        COMPARE_NEAR(front({0, 0.02, -1}, Vec3::UnitZ())->point.z(), inside->point.z(), 1e-4, "m");
        QVERIFY(!front({1, 0.02, 0.03}, -Vec3::UnitX()));
        COMPARE_NEAR(front({1, 0, -0.03}, -Vec3::UnitX())->point.x(), 0.04, 1e-4, "m");
        QVERIFY(picker.isFree({0, 0, 0.1}, {0, 0, 0}));
        plane.frame.rotation = Quat(Eigen::AngleAxisd(EIGEN_PI, Vec3::UnitX())); // the other side
        picker.setSection(plane);
        COMPARE_NEAR(front({0, 0.02, 1}, -Vec3::UnitZ())->point.z(), -inside->point.z(), 1e-4, "m");
        QVERIFY(!front({1, 0, -0.03}, -Vec3::UnitX()));
    }

    void aWayThroughTheModelIsNotFree() {
        ScenePicker picker;
        picker.setScene(ballScene());
        QVERIFY(!picker.isFree({0, 0, 0.1}, {0, 0, -0.1}));
        QVERIFY(picker.isFree({0, 0, 0.1}, {0, 0, 0.06}));
        QVERIFY(picker.isFree({0.06, 0, 0.1}, {0.06, 0, -0.1}));
    }

    void anEmptySceneAnswersNothing() { QVERIFY(!cast(Scene{}, {0, 0, 1}, -Vec3::UnitZ())); }

    void aSceneWithoutExtentAnswersNothing() {
        auto point = std::make_shared<TriangleSoup>();
        point->positions = {Vec3::Zero()};
        point->triangles = {{0, 0, 0}};
        point->surfaceOf = {0};
        SceneObject object;
        object.geometry = point;
        object.surfaces.resize(1);
        Scene scene;
        scene.add(object);
        QVERIFY(!cast(scene, {0, 0, 1}, -Vec3::UnitZ()));
    }

    void aMillionTrianglesAnswerRightAndTheirTimeIsReported() {
        ScenePicker picker;
        picker.setScene(ballScene(1000, 500));
        picker.cast({{0, 0, 1}, -Vec3::UnitZ()}, ScenePicker::Patience::Wait);
        constexpr int kRays = 2000;
        int hits = 0;
        QElapsedTimer clock;
        clock.start();
        for (int i = 0; i < kRays; ++i) {
            const Vec3 from(0.06 * std::sin(i), 0.06 * std::cos(3 * i), 1);
            const bool expected = std::hypot(from.x(), from.y()) < 0.9999 * kBallRadius;
            hits += expected == picker.cast({from, -Vec3::UnitZ()}, ScenePicker::Patience::Wait).has_value();
        }
        qInfo("one ray against a million triangles: %.2f us", 1e-3 * double(clock.nsecsElapsed()) / kRays);
        QCOMPARE_GE(hits, kRays - 2); // a ray may graze the rim
    }
};

TACTUM_TEST(TestScenePicker)

} // namespace test_scene_picker

#include "test_scene_picker.moc"
