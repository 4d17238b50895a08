#include <cmath>

#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "ui/view/view_camera.h"

namespace test_view_camera {

using namespace tactum;

namespace {

ViewCamera camera() {
    ViewCamera result;
    result.focus = {0.1, -0.2, 0.3};
    result.distance = 0.8;
    result.yaw = 0.7;
    result.pitch = 0.4;
    result.size = {900, 600};
    return result;
}

double apart(QPointF a, QPointF b) {
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

} // namespace

class TestViewCamera : public QObject {
    Q_OBJECT
private slots:
    void frontLooksAlongMinusZWithYUp() {
        ViewCamera front;
        QCOMPARE_LT((front.forward() + Vec3::UnitZ()).norm(), 1e-12);
        COMPARE_NEAR(front.up(), Vec3::UnitY(), 1e-12, "");
        COMPARE_NEAR(front.right(), Vec3::UnitX(), 1e-12, "");
    }

    void topKeepsAnUprightPicture() {
        ViewCamera top;
        top.pitch = 0.5 * EIGEN_PI;
        QCOMPARE_LT((top.forward() + Vec3::UnitY()).norm(), 1e-12);
        QCOMPARE_LT((top.up() + Vec3::UnitZ()).norm(), 1e-12);
    }

    void aRayShowsItsOwnPixel() {
        for (QPointF pixel : {QPointF(0, 0), QPointF(450, 300), QPointF(123, 577)}) {
            const auto seen = camera().project(camera().ray(pixel).at(0.37));
            QVERIFY(seen);
            QCOMPARE_LT(apart(*seen, pixel), 1e-6);
        }
    }

    void whatLiesBehindTheEyeHasNoPixel() {
        QVERIFY(!camera().project(camera().eye() - 0.1 * camera().forward()));
    }

    void aDragVectorMovesAPointByItsPixels() {
        const Vec3 p = camera().focus + Vec3(0.05, 0.02, 0.1);
        const QPointF drag(37, -21);
        const Vec3 moved = p + camera().dragVector(p, drag);
        QCOMPARE_LT(apart(*camera().project(moved) - *camera().project(p), drag), 1e-9);
        COMPARE_NEAR(camera().depth(moved), camera().depth(p), 1e-12, "m");
    }

    void zoomLeavesTheAnchorUnderTheCursor() {
        const Vec3 anchor(0.2, -0.1, 0.25);
        ViewCamera zoomed = camera();
        zoomed.zoomTo(anchor, 0.6);
        QCOMPARE_LT(apart(*zoomed.project(anchor), *camera().project(anchor)), 1e-9);
        COMPARE_NEAR(zoomed.depth(anchor), 0.6 * camera().depth(anchor), 1e-12, "m");
    }

    void orbitKeepsTheFocusInPlace() {
        ViewCamera turned = camera();
        turned.orbit({80, 45});
        QCOMPARE_LT(apart(*turned.project(camera().focus), QPointF(450, 300)), 1e-9);
        QCOMPARE_NE(turned.yaw, camera().yaw);
        QCOMPARE_GT(turned.pitch, camera().pitch);
        turned.orbit({0, 1e6});
        QVERIFY(turned.pitch <= 0.5 * EIGEN_PI);
    }

    void panMovesTheFocusWithTheCursor() {
        ViewCamera moved = camera();
        moved.pan({30, -12});
        QCOMPARE_LT(apart(*moved.project(camera().focus), QPointF(480, 288)), 1e-9);
    }

    /// A pixel at the focus is the view's height over its pixels.
    void aPixelHasALength() {
        ViewCamera c = camera();
        COMPARE_NEAR(c.pixelSize(c.focus), 2 * 0.8 * std::tan(0.25) / 600, 1e-12, "m");
        COMPARE_NEAR(c.pixelSize(c.focus + 0.8 * c.forward()), 2 * c.pixelSize(c.focus), 1e-12, "m");
        COMPARE_NEAR(c.depth(c.focus), 0.8, 1e-12, "m");
        COMPARE_NEAR(c.depth(c.eye()), 0, 1e-12, "m");
        COMPARE_NEAR((c.pointAtDepthOf(c.focus, {450, 300}) - c.focus).norm(), 0, 1e-12, "m");
        COMPARE_NEAR((*c.project(c.focus + 10 * c.pixelSize(c.focus) * c.right())).x(), 460, 1e-9, "pixels");
        COMPARE_NEAR((*c.project(c.focus + 10 * c.pixelSize(c.focus) * c.up())).y(), 290, 1e-9, "pixels");
        QVERIFY(!c.project(c.eye()));
    }

    /// OpenGL sees the same places as project().
    void clipSpaceAgreesWithPixels() {
        const ViewCamera c = camera();
        for (const Vec3& p : {c.focus, Vec3(c.focus + Vec3(0.1, 0.05, -0.1)), Vec3(0, 0, 0)}) {
            const Eigen::Vector4d clip = c.clipFromWorld() * p.homogeneous();
            const QPointF seen = *c.project(p);
            COMPARE_NEAR(clip.x() / clip.w(), 2 * seen.x() / 900 - 1, 1e-9, "");
            COMPARE_NEAR(clip.y() / clip.w(), 1 - 2 * seen.y() / 600, 1e-9, "");
            COMPARE_NEAR(clip.w(), c.depth(p), 1e-9, "m");
        }
        // From a thousandth of the distance to a thousand times it.
        for (const auto& [depth, z] : {std::pair(1e-3 * 0.8, -1.0), {1e3 * 0.8, 1.0}}) {
            const Eigen::Vector4d clip =
                c.clipFromWorld() * Vec3(c.eye() + depth * c.forward()).homogeneous();
            COMPARE_NEAR(clip.z() / clip.w(), z, 1e-6, "");
        }
    }

    void aParallelCameraKeepsSizes() {
        ViewCamera c = camera();
        c.parallel = true;
        const Vec3 near = c.focus - 0.3 * c.forward(), far = c.focus + 0.6 * c.forward();
        COMPARE_NEAR(c.pixelSize(near), c.pixelSize(far), 1e-12, "m");
        COMPARE_NEAR(c.pixelSize(c.focus), camera().pixelSize(c.focus), 1e-12, "m"); // as it was there
        for (const Vec3& p : {near, far})
            QCOMPARE_LT(apart(*c.project(p), QPointF(450, 300)), 1e-9);
        for (const QPointF pixel : {QPointF(0, 0), QPointF(123, 577)}) {
            COMPARE_NEAR(c.ray(pixel).direction, c.forward(), 1e-12, "");
            QCOMPARE_LT(apart(*c.project(c.ray(pixel).at(0.37)), pixel), 1e-6);
            COMPARE_NEAR(c.ray(pixel).at(c.depth(c.focus)), c.pointAtDepthOf(c.focus, pixel), 1e-9, "m");
        }
        for (const Vec3& p : {near, far, Vec3(0, 0, 0)}) {
            const Eigen::Vector4d clip = c.clipFromWorld() * p.homogeneous();
            COMPARE_NEAR(clip.x() / clip.w(), 2 * c.project(p)->x() / 900 - 1, 1e-9, "");
            COMPARE_NEAR(clip.y() / clip.w(), 1 - 2 * c.project(p)->y() / 600, 1e-9, "");
            QCOMPARE_LE(std::abs(clip.z() / clip.w()), 1.0);
        }
        const Vec3 anchor(0.2, -0.1, 0.25);
        ViewCamera zoomed = c;
        zoomed.zoomTo(anchor, 0.6);
        QCOMPARE_LT(apart(*zoomed.project(anchor), *c.project(anchor)), 1e-9);
        ViewCamera front;
        front.parallel = true;
        front.size = {600, 600};
        const Vec3 two[] = {{0, -1, 1}, {0, 1, -1}};
        front.fit(two);
        COMPARE_NEAR(front.distance, 1.2 / std::tan(0.25), 1e-9, "m");
    }

    /// Half a turn for the shorter side; to the right turns the model to the right, down shows its top.
    void aDragTurnsByItsLength() {
        ViewCamera c;
        c.size = {900, 600};
        c.orbit({150, 0});
        COMPARE_NEAR(c.yaw, -EIGEN_PI / 4, 1e-12, "rad");
        c.orbit({0, 150});
        COMPARE_NEAR(c.pitch, EIGEN_PI / 4, 1e-12, "rad");
        c.orbit({0, -1e6});
        COMPARE_NEAR(c.pitch, -EIGEN_PI / 2, 1e-12, "rad");
        c.orbit({-600 * 3, 0}); // three half turns
        COMPARE_NEAR(std::abs(std::remainder(c.yaw - 3 * EIGEN_PI / 4, 2 * EIGEN_PI)), 0, 1e-9, "rad");
        QCOMPARE_LE(std::abs(c.yaw), EIGEN_PI);
        ViewCamera high;
        high.size = {300, 900};
        high.orbit({300, 0});
        COMPARE_NEAR(std::abs(high.yaw), EIGEN_PI, 1e-9, "rad");
    }

    void fitLeavesWhatItCannotUse() {
        ViewCamera c = camera();
        c.fit({});
        COMPARE_NEAR(c.focus, camera().focus, 1e-12, "m");
        QCOMPARE(c.distance, 0.8);
        const Vec3 one[] = {{1, 2, 3}};
        c.fit(one);
        COMPARE_NEAR(c.focus, Vec3(1, 2, 3), 1e-12, "m");
        QCOMPARE(c.distance, 0.8);
        QCOMPARE(c.yaw, camera().yaw);
        // A margin of a fifth: what is fitted ends at 1 / 1.2 of the view.
        ViewCamera front;
        front.size = {600, 600};
        const Vec3 two[] = {{0, -1, 0}, {0, 1, 0}};
        front.fit(two);
        COMPARE_NEAR(front.distance, 1.2 / std::tan(0.25), 1e-9, "m");
        const Vec3 behind[] = {{0, 0, -1}, {0, 0, 1}};
        front.fit(behind); // never into what is looked at
        QCOMPARE_GE(front.distance, 1.0);
    }

    void fitShowsEveryPointAndFillsTheView() {
        const std::vector<Vec3> points{{-0.1, 0, 0}, {0.3, 0.1, 0}, {0, 0.2, -0.2}, {0.1, -0.3, 0.1}};
        for (QSizeF size : {QSizeF(900, 600), QSizeF(300, 700)}) {
            ViewCamera fitted = camera();
            fitted.size = size;
            fitted.fit(points);
            double fill = 0;
            for (const Vec3& p : points) {
                const QPointF seen = *fitted.project(p);
                QVERIFY(QRectF({0, 0}, size).contains(seen));
                fill = std::max({fill, std::abs(2 * seen.x() / size.width() - 1),
                                 std::abs(2 * seen.y() / size.height() - 1)});
            }
            QCOMPARE_GT(fill, 0.75);
            QCOMPARE_LT(fill, 0.95);
        }
    }
};

TACTUM_TEST(TestViewCamera)

} // namespace test_view_camera

#include "test_view_camera.moc"
