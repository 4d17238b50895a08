// A view that is kept: what was at a pixel is there again, also by way of a file.
#include <numbers>

#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "ui/view/saved_view.h"

namespace test_saved_view {

using namespace tactum;

namespace {

constexpr double kPixel = 1e-3; // what a person could not see by far

std::vector<ViewCamera> cameras() {
    std::vector<ViewCamera> all;
    for (const bool parallel : {false, true})
        for (const double pitch : {0.0, 0.6, -1.1, 0.5 * std::numbers::pi, -0.5 * std::numbers::pi})
            for (const double yaw : {0.0, 0.4, -2.2, 3.1}) {
                ViewCamera camera;
                camera.focus = {0.02, -0.01, 0.03};
                camera.distance = 0.3;
                camera.yaw = yaw, camera.pitch = pitch, camera.parallel = parallel;
                camera.fieldOfView = EIGEN_PI / 6;
                camera.size = {900, 600};
                all.push_back(camera);
            }
    return all;
}

double mostOff(const ViewCamera& a, const ViewCamera& b) {
    double most = 0;
    for (int i = 0; i < 8; ++i) {
        const Vec3 p(i & 1 ? 0.05 : -0.05, i & 2 ? 0.04 : -0.05, i & 4 ? 0.03 : -0.05);
        const auto before = a.project(p), after = b.project(p);
        if (!before || !after) return 1e9;
        most = std::max(most, std::hypot(before->x() - after->x(), before->y() - after->y()));
    }
    return most;
}

/// What the eye is like before the saved one is chosen.
ViewCamera elsewhere() {
    ViewCamera camera;
    camera.focus = {1, 1, 1};
    camera.yaw = 1, camera.pitch = 0.2, camera.distance = 4;
    camera.fieldOfView = EIGEN_PI / 6;
    camera.size = {900, 600};
    return camera;
}

} // namespace

class TestSavedView : public QObject {
    Q_OBJECT

private slots:
    void pointsAreAtTheSamePixels() {
        for (const ViewCamera& camera : cameras()) {
            const SavedCamera saved = savedCamera(camera, "view");
            QVERIFY(isCamera(saved));
            const ViewCamera back = viewOf(saved, elsewhere());
            QCOMPARE_LT(mostOff(camera, back), kPixel);
            COMPARE_NEAR(back.focus, camera.focus, 1e-9, "m"); // it turns about the same
            COMPARE_NEAR(back.distance, camera.distance, 1e-9, "m");
        }
    }

    /// glTF: it looks along -Z, and X is right.
    void theAxesAreThoseOfGltf() {
        for (const ViewCamera& camera : cameras()) {
            const SavedCamera saved = savedCamera(camera, "view");
            COMPARE_NEAR(saved.pose.rotate(-Vec3::UnitZ()), camera.forward(), 1e-12, "");
            COMPARE_NEAR(saved.pose.rotate(Vec3::UnitX()), camera.right(), 1e-12, "");
            COMPARE_NEAR(saved.pose.translation, camera.eye(), 1e-12, "m");
        }
    }

    void oneThatIsTiltedIsUpright() {
        SavedCamera saved = savedCamera(cameras()[1], "view");
        saved.pose.rotation = saved.pose.rotation * Quat(Eigen::AngleAxisd(0.5, Vec3::UnitZ()));
        const ViewCamera back = viewOf(saved, elsewhere());
        COMPARE_NEAR(back.forward(), cameras()[1].forward(), 1e-12, "");
        COMPARE_NEAR(back.eye(), cameras()[1].eye(), 1e-12, "m");
        COMPARE_NEAR(back.right().y(), 0, 1e-12, "");
    }

    void aLensOfAnotherProgramIsTaken() {
        SavedCamera saved = savedCamera(cameras()[1], "wide");
        saved.angle = 1.2;
        COMPARE_NEAR(viewOf(saved, elsewhere()).fieldOfView, 1.2, 1e-12, "rad");
    }

    /// Which a file may have, and which no screen can show.
    void aLensNextToNoneGivesAView() {
        for (const double angle :
             {std::numeric_limits<double>::min(), std::nextafter(std::numbers::pi, 0.0)}) {
            SavedCamera saved = savedCamera(cameras()[1], "odd");
            saved.angle = angle;
            QVERIFY(isCamera(saved));
            const ViewCamera view = viewOf(saved, elsewhere());
            const auto seen = view.project(view.focus + 1e-6 * view.right());
            QVERIFY(seen && std::isfinite(seen->x()) && std::isfinite(seen->y()));
            QCOMPARE_GT(view.pixelSize(view.focus), 1e-9);
        }
    }
};

TACTUM_TEST(TestSavedView)

} // namespace test_saved_view

#include "test_saved_view.moc"
