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
