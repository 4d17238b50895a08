// Saved cameras: what one must be, kept, renamed, removed, and what becomes of them when scenes change.
#include <limits>

#include <QTest>

#include "core/scene/carry_feel.h"
#include "core/scene/compose.h"
#include "core/scene/placing.h"
#include "tests/core/scene/things.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_saved_cameras {

using namespace tactum;
using namespace tactum::test;

namespace {

SavedCamera cameraAt(const std::string& name, const Vec3& eye, bool parallel = false) {
    SavedCamera camera;
    camera.name = name;
    camera.pose.translation = eye;
    camera.parallel = parallel;
    return camera;
}

Scene boxScene() {
    Scene scene;
    add(scene, "box", box({1, 1, 1}));
    return scene;
}

} // namespace

class TestSavedCameras : public QObject {
    Q_OBJECT

private slots:
    void whatNothingIsSeenByIsNone() {
        const double nan = std::numeric_limits<double>::quiet_NaN(),
                     infinite = std::numeric_limits<double>::infinity();
        const SavedCamera good = cameraAt("front", {0, 0, 1});
        QVERIFY(isCamera(good));
        QVERIFY(!isCamera(cameraAt("", {0, 0, 1})));
        QVERIFY(!isCamera(cameraAt("far", {0, 0, 1.1e6})));
        for (double SavedCamera::*member : {&SavedCamera::angle, &SavedCamera::height, &SavedCamera::ahead})
            for (const double bad : {nan, infinite, 0.0, -1.0, 1e7}) {
                SavedCamera camera = good;
                camera.*member = bad;
                QVERIFY2(!isCamera(camera), qPrintable(QString::number(bad)));
            }
        for (double SavedCamera::*member : {&SavedCamera::near, &SavedCamera::far})
            for (const double bad : {nan, infinite, -1.0}) {
                SavedCamera camera = good;
                camera.*member = bad;
                QVERIFY(!isCamera(camera));
            }
        SavedCamera turned = good;
        turned.pose.rotation.coeffs() *= 2;
        QVERIFY(!isCamera(turned));
        QVERIFY(areCameras({good, cameraAt("back", {0, 0, -1})}));
        QVERIFY(!areCameras({good, good}));
        QVERIFY(!areCameras({good, turned}));
    }

    void oneIsKeptUpdatedRenamedAndRemoved() {
        Scene scene = boxScene();
        putCamera(scene, cameraAt("front", {0, 0, 1}));
        putCamera(scene, cameraAt("back", {0, 0, -1}));
        scene.cameras[0].kept.index = 3;
        putCamera(scene, cameraAt("front", {0, 0, 2}));
        QCOMPARE(scene.cameras.size(), 2u);
        COMPARE_NEAR(findCamera(scene, "front")->pose.translation, Vec3(0, 0, 2), 1e-15, "m");
        QCOMPARE(scene.cameras[0].kept.index, 3); // its place in the file stays
        renameCamera(scene, "front", "back");
        QCOMPARE(scene.cameras[0].name, std::string("front")); // that is another one
        renameCamera(scene, "front", "near");
        QCOMPARE(scene.cameras[0].name, std::string("near"));
        removeCamera(scene, "back");
        QCOMPARE(scene.cameras.size(), 1u);
        QVERIFY(!findCamera(scene, "back"));
    }

    void thereAreNotMoreThanCanBe() {
        Scene scene = boxScene();
        for (std::size_t i = 0; i < kMaxCameras + 5; ++i)
            putCamera(scene, cameraAt(std::to_string(i), {0, 0, 1}));
        QCOMPARE(scene.cameras.size(), kMaxCameras);
        QVERIFY(areCameras(scene.cameras));
    }

    /// From where the same is seen, a thousandth as large.
    void camerasAreScaledAndTurnedWithTheScene() {
        Scene scene = boxScene();
        scene.cameras = {cameraAt("eye", {1, 2, 3}), cameraAt("plan", {1, 2, 3}, true)};
        scene.cameras[0].near = 0.5, scene.cameras[0].far = 100;
        scaleScene(scene, 1e-3, {1, 0, 0});
        COMPARE_NEAR(scene.cameras[0].pose.translation, Vec3(0, 2e-3, 3e-3), 1e-15, "m");
        COMPARE_NEAR(scene.cameras[0].ahead, 1e-3, 1e-15, "m");
        COMPARE_NEAR(scene.cameras[0].near, 5e-4, 1e-15, "m");
        COMPARE_NEAR(scene.cameras[0].height, 1, 1e-15, "m"); // it has an angle instead
        COMPARE_NEAR(scene.cameras[1].height, 1e-3, 1e-15, "m");
        QVERIFY(turnUpright(scene));
        COMPARE_NEAR(scene.cameras[0].pose.translation, Vec3(0, 3e-3, -2e-3), 1e-15, "m");
        COMPARE_NEAR(scene.cameras[0].pose.rotate(-Vec3::UnitZ()), Vec3(0, -1, 0), 1e-12, "");
    }

    void oneThatScalingTakesTooFarGoes() {
        Scene scene = boxScene();
        scene.cameras = {cameraAt("near", {0, 0, 1}), cameraAt("far", {0, 0, 9e5})};
        scaleScene(scene, 10, Vec3::Zero());
        QCOMPARE(scene.cameras.size(), 1u);
        QCOMPARE(scene.cameras[0].name, std::string("near"));
    }

    void addedScenesBringTheirsWhereNothingIs() {
        Scene other = boxScene();
        other.cameras = {cameraAt("front", {0, 0, 1})};
        other.cameras[0].kept.index = 2;
        Scene scene = boxScene();
        addScene(scene, other, 10);
        QCOMPARE(scene.cameras.size(), 0u);
        Scene empty;
        empty.cameras = {cameraAt("mine", {0, 0, 2})};
        empty.cameras[0].kept.index = 2; // of a file that is no more that of the scene
        addScene(empty, other, 10);
        QCOMPARE(empty.cameras.size(), 2u);
        QCOMPARE(empty.cameras[0].kept.index, -1);
        QCOMPARE(empty.cameras[1].kept.index, 2);
    }

    void theyComeAlongOntoAnotherModel() {
        Scene scene = boxScene(), next = boxScene();
        scene.cameras = {cameraAt("front", {0, 0, 1}), cameraAt("mine", {0, 0, 2})};
        scene.cameras[1].kept.index = 7;
        next.cameras = {cameraAt("front", {0, 0, 5}), cameraAt("theirs", {0, 0, 6})};
        carryFeel(scene, next);
        QCOMPARE(next.cameras.size(), 3u);
        COMPARE_NEAR(findCamera(next, "front")->pose.translation.z(), 1, 1e-15, "m");
        QCOMPARE(findCamera(next, "mine")->kept.index, -1);
    }
};

TACTUM_TEST(TestSavedCameras)

} // namespace test_saved_cameras

#include "test_saved_cameras.moc"
