// The judge of exactness itself, on proxies that are where they should be and on proxies that are not.
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/exactness.h"
#include "tests/support/hand.h"
#include "tests/support/reference.h"
#include "tests/support/test_program.h"

namespace test_exactness {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kRadius = 1e-3;

TouchRow row(const Vec3& proxy, const Vec3& finger) {
    TouchRow r;
    r.proxy = proxy;
    r.finger = finger;
    return r;
}

} // namespace

class TestExactness : public QObject {
    Q_OBJECT

private slots:
    void gridSeesWhatBruteForceSees();
    void aProxyAtRestIsAtItsMinimum();
    void aProxyAsideIsFarByTheWayThatIsLeft();
    void goesAroundAnEdgeWhereThePlaneOfTheFaceEnds();
    void countsRows();
    void noticesAProxyInside();
};

void TestExactness::gridSeesWhatBruteForceSees() {
    Rng rng(7);
    for (int i = 0; i < 50; ++i) {
        const Soup soup = randomSoup(rng, 200, 0.01);
        const TriangleGrid grid(*soup, uniform(rng, 1e-4, 1e-2));
        // Just far enough: a grid that files a triangle under another cell, the first or the last, is found
        // out.
        const Bounds box = boundsOf(*soup);
        for (const Vec3& p : {inBox(rng, 0.015), box.low, box.high}) {
            const double expected = clearance(*soup, p);
            QCOMPARE(clearance(grid, p, 1.01 * expected), expected);
        }
    }
}

void TestExactness::aProxyAtRestIsAtItsMinimum() {
    const Soup floor = sheet(0.05, 3);
    const TriangleGrid grid(*floor, kRadius);
    QCOMPARE_LT(distanceFromMinimum(grid, kRadius, {0.003, 0.002, kRadius}, {0.003, 0.002, -0.005}), 1e-12);
    // In a valley, with the finger below its bottom but not in its middle: the bottom holds.
    const Soup valley = wedge(std::numbers::pi / 2, 0.05);
    const TriangleGrid valleyGrid(*valley, kRadius);
    const Vec3 bottom(0, 0, kRadius * std::numbers::sqrt2);
    QCOMPARE_LT(distanceFromMinimum(valleyGrid, kRadius, bottom, bottom + Vec3(1e-3, 0, -4e-3)), 1e-12);
}

void TestExactness::aProxyAsideIsFarByTheWayThatIsLeft() {
    const Soup floor = sheet(0.05, 3);
    const TriangleGrid grid(*floor, kRadius);
    for (double aside : {1e-7, 20e-6, 3e-3}) {
        const double far = distanceFromMinimum(grid, kRadius, {0, 0, kRadius}, {aside, 0, -0.005});
        COMPARE_NEAR(far, aside, 1e-12, "");
    }
    // Held above the floor by nothing.
    const double far = distanceFromMinimum(grid, kRadius, {0, 0, kRadius + 2e-3}, {0, 0, -0.005});
    COMPARE_NEAR(far, 2e-3, 1e-12, "");
}

void TestExactness::goesAroundAnEdgeWhereThePlaneOfTheFaceEnds() {
    // The sheet ends at x = 0.01: beyond it the proxy rolls down around the edge to the finger.
    const Soup floor = sheet(0.01);
    const TriangleGrid grid(*floor, kRadius);
    const Vec3 finger(0.0112, 0, -0.004);
    const double far = distanceFromMinimum(grid, kRadius, {0.0095, 0, kRadius}, finger);
    QCOMPARE(far, (finger - Vec3(0.0095, 0, kRadius)).norm());
}

void TestExactness::countsRows() {
    const Soup floor = sheet(0.05, 3);
    const Vec3 finger(0, 0, -0.002);
    const Exactness e = exactnessOf(*floor, kRadius,
                                    {row({0, 0, kRadius}, finger), row({20e-6, 0, kRadius}, finger),
                                     row({2e-3, 0, kRadius}, finger), row({0, 0, 0.9 * kRadius}, finger)});
    QCOMPARE(e.rows, std::size_t(4));
    QCOMPARE(e.offRows, std::size_t(2));
    QCOMPARE(e.farRows, std::size_t(1));
    QCOMPARE(e.faults.size(), std::size_t(3));
    QCOMPARE(e.faults.back().row, std::size_t(3));
    COMPARE_NEAR(e.worst, 2e-3, 1e-12, "");
    QCOMPARE_LT(std::abs(e.smallestClearance + 0.1 * kRadius), 1e-12);
    COMPARE_NEAR(e.deepest, std::hypot(2e-3, 3e-3), 1e-12, "");
    QVERIFY(!e.closed);
}

void TestExactness::noticesAProxyInside() {
    auto icosahedra = std::make_shared<TriangleSoup>(*ball(0.02, 3));
    const Vec3 above(0, 0, 0.0215), under(0, 0, 0.018);
    QCOMPARE(exactnessOf(*icosahedra, kRadius, {row(above, under), row(under, under), row(under, under)})
                 .insideRows,
             std::size_t(2));
    // Around to the other side is a long way too, but not one through the surface.
    QCOMPARE(exactnessOf(*icosahedra, kRadius, {row(above, under), row(-above, -under)}).insideRows,
             std::size_t(0));
}

TACTUM_TEST(TestExactness)

} // namespace test_exactness

#include "test_exactness.moc"
