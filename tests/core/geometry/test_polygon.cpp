// Polygons are covered by their triangles: same area, same side, every corner used, none outside.
#include <random>

#include <QTest>

#include "core/geometry/polygon.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_polygon {

using namespace tactum;

namespace {

Vec3 areaVector(const std::vector<Vec3>& corners, const std::array<Index, 3>& t) {
    return 0.5 * (corners[t[1]] - corners[t[0]]).cross(corners[t[2]] - corners[t[0]]);
}

double polygonArea(const std::vector<Vec3>& corners) {
    return 0.5 * newellNormal(corners).norm();
}

/// Areas add up only if no triangle lies outside or over another one.
double coveredArea(const std::vector<Vec3>& corners, const std::vector<std::array<Index, 3>>& triangles) {
    double area = 0;
    for (const auto& t : triangles)
        area += areaVector(corners, t).norm();
    return area;
}

void compareCover(const std::vector<Vec3>& corners) {
    PolygonCutter cutter;
    const auto triangles = cutter.cut(corners);
    QCOMPARE(triangles.size(), corners.size() - 2);
    QVERIFY(!cutter.gaveUp());
    const Vec3 normal = newellNormal(corners);
    for (const auto& t : triangles)
        QCOMPARE_GE(areaVector(corners, t).dot(normal), 0);
    COMPARE_NEAR(coveredArea(corners, triangles) / polygonArea(corners), 1, 1e-9, "");
}

/// Star-shaped about the origin, with any radii: often very concave.
std::vector<Vec3> randomStar(std::size_t corners, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<Vec3> star;
    for (std::size_t i = 0; i < corners; ++i) {
        const double angle = 2 * M_PI * double(i) / double(corners),
                     radius = 0.1 + double(random() % 1000) / 1000;
        star.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
    return star;
}

std::vector<Vec3> turnedAndMoved(std::vector<Vec3> corners, unsigned seed) {
    std::srand(seed);
    const Quat turn = Quat::UnitRandom();
    for (Vec3& p : corners)
        p = turn * p + Vec3(3, -2, 5);
    return corners;
}

} // namespace

class TestPolygon : public QObject {
    Q_OBJECT

private slots:
    void concaveShapesKeepTheirArea_data() {
        QTest::addColumn<std::vector<Vec3>>("corners");
        QTest::newRow("arrow") << std::vector<Vec3>{{0, 0, 0}, {2, 2, 0}, {0, 1, 0}, {-2, 2, 0}};
        QTest::newRow("L") << std::vector<Vec3>{{0, 0, 0}, {4, 0, 0}, {4, 1, 0},
                                                {1, 1, 0}, {1, 5, 0}, {0, 5, 0}};
        QTest::newRow("comb") << std::vector<Vec3>{
            {0, 0, 0}, {7, 0, 0}, {7, 5, 0}, {6, 5, 0}, {6, 1, 0}, {5, 1, 0}, {5, 5, 0}, {4, 5, 0},
            {4, 1, 0}, {3, 1, 0}, {3, 5, 0}, {2, 5, 0}, {2, 1, 0}, {1, 1, 0}, {1, 5, 0}, {0, 5, 0}};
        QTest::newRow("corners on edges") << std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0},
                                                               {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}};
        QTest::newRow("ring through a bridge")
            << std::vector<Vec3>{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                                 {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
    }
    void concaveShapesKeepTheirArea() {
        QFETCH(std::vector<Vec3>, corners);
        compareCover(corners);
        for (std::size_t start = 1; start < corners.size();
             ++start) { // whichever corner the file begins with
            std::rotate(corners.begin(), corners.begin() + 1, corners.end());
            if (corners.front() != corners.back()) compareCover(corners);
        }
        std::reverse(corners.begin(), corners.end());
        if (corners.front() != corners.back()) compareCover(corners);
    }

    void randomStarsInAnyPlaneKeepTheirArea() {
        for (unsigned seed = 0; seed < 300; ++seed) {
            compareCover(randomStar(3 + seed % 60, seed));
            compareCover(turnedAndMoved(randomStar(4 + seed % 60, seed), seed));
        }
    }

    void cornersOnAnEdgeMakeNoFlatTriangles() {
        std::vector<Vec3> corners{{0, 1, 0}};
        for (int i = 0; i <= 50; ++i)
            corners.emplace_back(i / 50.0, 0, 0);
        PolygonCutter cutter;
        for (const auto& t : cutter.cut(corners))
            QCOMPARE_GT(areaVector(corners, t).norm(), 0.005);
    }

    void theShorterDiagonalCutsAQuad() {
        const std::vector<Vec3> kite{{0, 0, 0}, {3, -1, 0}, {6, 0, 0}, {3, 1, 0}};
        PolygonCutter cutter;
        for (const auto& t : cutter.cut(kite))
            QCOMPARE(std::count(t.begin(), t.end(), Index(1)) + std::count(t.begin(), t.end(), Index(3)), 2);
    }

    void repeatedCornersCountOnce() {
        const std::vector<Vec3> corners{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0},
                                        {1, 1, 0}, {0, 1, 0}, {0, 0, 0}};
        PolygonCutter cutter;
        const auto triangles = cutter.cut(corners);
        QCOMPARE(triangles.size(), std::size_t(2));
        COMPARE_NEAR(coveredArea(corners, triangles), 1, 1e-12, "m²");
    }

    void whatHasNoAreaIsASegmentOrAPoint() {
        using Triangles = std::vector<std::array<Index, 3>>;
        PolygonCutter cutter;
        const Vec3 a(0, 0, 0), b(1, 2, 3);
        QCOMPARE(cutter.cut(std::vector{a, b, a, a}), (Triangles{{0, 1, 1}})); // there and back
        QCOMPARE(cutter.cut(std::vector{a, b, b}), (Triangles{{0, 1, 1}}));
        QCOMPARE(cutter.cut(std::vector{a, b}), (Triangles{{0, 1, 1}}));
        QCOMPARE(cutter.cut(std::vector{b, b, b, b}), (Triangles{{0, 0, 0}}));
        QCOMPARE(cutter.cut(std::vector{b}), (Triangles{{0, 0, 0}}));
        QCOMPARE(cutter.cut(std::vector<Vec3>{}), Triangles{});
    }

    void cornersOnOneLineAreAllUsed() {
        std::vector<Vec3> corners;
        for (int i : {0, 3, 1, 2, 5, 4})
            corners.emplace_back(i, 2 * i, 0);
        std::vector<char> used(corners.size(), 0);
        PolygonCutter cutter;
        for (const auto& t : cutter.cut(corners))
            for (Index corner : t)
                used[corner] = 1;
        QCOMPARE(std::count(used.begin(), used.end(), 1), 6);
    }

    void outlinesThatCrossAreStillCovered() {
        std::mt19937 random(5);
        for (int round = 0; round < 300; ++round) {
            std::vector<Vec3> corners;
            for (unsigned i = 0; i < 4 + random() % 30; ++i) {
                const double x = random() % 8, y = random() % 8;
                corners.emplace_back(x, y, random() % 3);
            }
            PolygonCutter cutter;
            std::vector<char> used(corners.size(), 0);
            for (const auto& t : cutter.cut(corners))
                for (Index corner : t)
                    used[corner] = 1;
            for (std::size_t i = 0; i < corners.size(); ++i) // only repeated places may be unused
                QVERIFY(used[i] || corners[i] == corners[(i + corners.size() - 1) % corners.size()] ||
                        corners[i] == corners[(i + 1) % corners.size()]);
        }
    }

    /// A thousand times the usual size: bounded, and a zigzag that defeats ear clipping says so.
    void hugePolygonsEnd() {
        std::vector<Vec3> round;
        for (int i = 0; i < 100'000; ++i)
            round.emplace_back(std::cos(M_PI * i / 5e4), std::sin(M_PI * i / 5e4), 0);
        PolygonCutter cutter;
        COMPARE_NEAR(coveredArea(round, cutter.cut(round)), M_PI, 1e-6, "m²");
        QVERIFY(!cutter.gaveUp());
        const std::vector<Vec3> star = randomStar(200'000, 1);
        QCOMPARE(cutter.cut(star).size(), star.size() - 2);
        QVERIFY(cutter.gaveUp());
    }
};

TACTUM_TEST(TestPolygon)

} // namespace test_polygon

#include "test_polygon.moc"
