// The box on the screen against a slow answer: points all over each triangle, projected one by one.
#include <cmath>
#include <random>

#include <QTest>

#include "core/geometry/box_select.h"
#include "tests/core/geometry/meshes.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_box_select {

using namespace tactum;
using namespace tactum::test;

namespace {

/// Looks along -z from the origin; half the height of the view is as far as it is away.
Eigen::Matrix4d perspective(double near, double far) {
    Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
    m(0, 0) = m(1, 1) = 1;
    m(2, 2) = (near + far) / (near - far);
    m(2, 3) = 2 * near * far / (near - far);
    m(3, 2) = -1;
    return m;
}

Eigen::Matrix4d moved(const Vec3& by) {
    return Eigen::Affine3d(Eigen::Translation3d(by)).matrix();
}

bool isIn(const Eigen::Matrix4d& clip, const ScreenBox& box, const Vec3& p) {
    const Eigen::Vector4d q = clip * p.homogeneous();
    return q.z() >= -q.w() && q.x() >= box.left * q.w() && q.x() <= box.right * q.w() &&
           q.y() >= box.bottom * q.w() && q.y() <= box.top * q.w();
}

} // namespace

class TestBoxSelect : public QObject {
    Q_OBJECT

private slots:
    void aBoxOverASquareOfAGrid() {
        const TriangleSoup soup = grid(8, [](double, double) { return 0.0; }); // 1/8 a square
        const Eigen::Matrix4d clip = perspective(0.1, 10) * moved({0, 0, -1});
        const auto taken = [&](double low, double high, BoxRule rule) {
            return trianglesInBox(soup, clip, {low, low, high, high}, rule).size();
        };
        QCOMPARE(taken(0.26, 0.37, {}), std::size_t(2)); // inside one square, over its diagonal
        QCOMPARE(taken(0.26, 0.37, {.whole = true}), std::size_t(0));
        QCOMPARE(taken(0.24, 0.51, {.whole = true}), std::size_t(8));
        QCOMPARE(taken(0.24, 0.51, {}), std::size_t(32 - 2)); // 16 squares, two of them by one triangle
        QCOMPARE(taken(-1, 1, {.whole = true}), std::size_t(128));
        QCOMPARE(taken(2, 3, {}), std::size_t(0));
    }

    /// A box inside one large triangle has none of its corners and crosses none of its edges.
    void aTriangleThatFillsTheBoxTouchesIt() {
        TriangleSoup soup;
        soup.positions = {{-9, -9, -1}, {9, -9, -1}, {0, 9, -1}};
        soup.triangles = {{0, 1, 2}};
        soup.surfaceOf = {0};
        const Eigen::Matrix4d clip = perspective(0.1, 10);
        QCOMPARE(trianglesInBox(soup, clip, {-0.1, -0.1, 0.1, 0.1}).size(), std::size_t(1));
        QVERIFY(trianglesInBox(soup, clip, {-0.1, -0.1, 0.1, 0.1}, {.whole = true}).empty());
        // A box beside it that its box would reach into.
        QVERIFY(trianglesInBox(soup, clip, {-9, 8, -8, 9}).empty());
    }

    void onlyFrontsThatLookToTheEye() {
        const TriangleSoup soup = cube({-0.5, -0.5, -3});
        const Eigen::Matrix4d clip = perspective(0.1, 10);
        QCOMPARE(trianglesInBox(soup, clip, {}, {}).size(), std::size_t(12));
        QCOMPARE(trianglesInBox(soup, clip, {}, {.frontOnly = true}), (TriangleSet{2, 3})); // z = -2
        const Eigen::Matrix4d above = clip * moved({0, -2, 0});
        QCOMPARE(trianglesInBox(soup, above, {-9, -9, 9, 9}, {.frontOnly = true}), (TriangleSet{2, 3, 6, 7}));
    }

    void whatIsBehindTheEyeIsNotOnTheScreen() {
        const Eigen::Matrix4d clip = perspective(0.1, 10);
        QVERIFY(trianglesInBox(cube({-0.5, -0.5, 1}), clip, {}).empty());
        // From behind the eye to before it, through the box only in front.
        TriangleSoup soup;
        soup.positions = {{0, 0, 5}, {0.01, 0, 5}, {0, 0, -5}};
        soup.triangles = {{0, 1, 2}, {0, 1, 1}, {0, 2, 2}, {2, 2, 2}};
        soup.surfaceOf.assign(4, 0);
        QCOMPARE(trianglesInBox(soup, clip, {-0.1, -0.1, 0.1, 0.1}), (TriangleSet{0, 2, 3}));
    }

    /// Never less than any point of the triangle in the box says, and not much more than a box a little
    /// larger.
    void randomTrianglesAgreeWithTheirPoints() {
        std::mt19937 random(3);
        const auto part = [&](double low, double high) {
            return low + (high - low) * (random() % 4096) / 4095;
        };
        int taken = 0, left = 0;
        for (int round = 0; round < 2000; ++round) {
            TriangleSoup soup;
            for (int i = 0; i < 3; ++i)
                soup.positions.emplace_back(part(-2, 2), part(-2, 2), part(-4, 1));
            soup.triangles = {{0, 1, 2}};
            soup.surfaceOf = {0};
            const Eigen::Matrix4d clip = perspective(0.1, 10);
            const double x = part(-1, 0.8), y = part(-1, 0.8), size = part(0.05, 0.5), more = 0.03;
            const ScreenBox box{x, y, x + size, y + size};
            const ScreenBox larger{x - more, y - more, x + size + more, y + size + more};
            bool inside = false, near = false;
            for (int i = 0; i <= 200; ++i)
                for (int j = 0; i + j <= 200; ++j) {
                    const Vec3 p =
                        (i * soup.positions[0] + j * soup.positions[1] + (200 - i - j) * soup.positions[2]) /
                        200.0;
                    inside |= isIn(clip, box, p);
                    near |= isIn(clip, larger, p);
                }
            const bool found = !trianglesInBox(soup, clip, box).empty();
            if (inside) QVERIFY(found);
            if (found) QVERIFY(near);
            (found ? taken : left)++;
        }
        QCOMPARE_GT(taken, 200);
        QCOMPARE_GT(left, 200);
    }
};

TACTUM_TEST(TestBoxSelect)

} // namespace test_box_select

#include "test_box_select.moc"
