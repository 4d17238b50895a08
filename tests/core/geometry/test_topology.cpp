// Corner normals for display, also on meshes that a half-edge structure cannot hold.
#include <cmath>
#include <random>

#include <QTest>

#include "core/geometry/topology.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_topology {

using namespace tactum;

namespace {

constexpr double kRightAngle = M_PI / 2;

TriangleSoup cube() {
    TriangleSoup soup;
    for (int i = 0; i < 8; ++i)
        soup.positions.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
    soup.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return soup;
}

Vec3 faceNormal(const TriangleSoup& soup, std::size_t f) {
    const auto& t = soup.triangles[f];
    const Vec3& a = soup.positions[t[0]];
    return (soup.positions[t[1]] - a).cross(soup.positions[t[2]] - a).normalized();
}

std::vector<Eigen::Vector3f> normals(const TriangleSoup& soup, double crease) {
    return cornerNormalsOf(soup, crease).value();
}

} // namespace

class TestTopology : public QObject {
    Q_OBJECT

private slots:
    void aSharpCubeHasFlatFaces() {
        const TriangleSoup soup = cube();
        const auto found = normals(soup, 0.5 * kRightAngle);
        for (std::size_t i = 0; i < found.size(); ++i)
            COMPARE_NEAR(found[i].cast<double>(), faceNormal(soup, i / 3), 1e-6, "");
    }

    /// Weighted by angle, so that how a side is cut into triangles does not show.
    void aSmoothCubePointsAlongItsDiagonals() {
        const TriangleSoup soup = cube();
        const auto found = normals(soup, 1.5 * kRightAngle);
        for (std::size_t i = 0; i < found.size(); ++i) {
            const Vec3 corner = soup.positions[soup.triangles[i / 3][i % 3]];
            COMPARE_NEAR(found[i].cast<double>(), (corner - Vec3::Constant(0.5)).normalized(), 1e-6, "");
        }
    }

    void seamsOfSplitVerticesDoNotShow() {
        const TriangleSoup whole = cube();
        TriangleSoup split;
        for (const auto& t : whole.triangles) {
            const Index first = Index(split.positions.size());
            for (Index corner : t)
                split.positions.push_back(whole.positions[corner]);
            split.triangles.push_back({first, first + 1, first + 2});
        }
        const auto expected = normals(whole, M_PI), found = normals(split, M_PI);
        for (std::size_t i = 0; i < found.size(); ++i)
            COMPARE_NEAR(found[i].cast<double>(), expected[i].cast<double>(), 1e-6, "");
    }

    void eachTriangleAtANonManifoldEdgeKeepsItsOwn() {
        TriangleSoup soup;
        soup.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}};
        soup.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
        const auto found = normals(soup, M_PI);
        for (std::size_t i = 0; i < found.size(); ++i)
            COMPARE_NEAR(found[i].cast<double>(), faceNormal(soup, i / 3), 1e-6, "");
    }

    void segmentsGetSomeNormal() {
        TriangleSoup soup = cube();
        soup.triangles.push_back({0, 7, 7});
        const auto found = normals(soup, 1);
        QCOMPARE(found.size(), std::size_t(39));
        COMPARE_NEAR(found[36].cast<double>(), Vec3(0, 0, 1), 1e-6, "");
    }

    /// Any soup: an answer of unit length for every corner, on the front side of triangles that stand alone.
    void randomSoupsGetANormalForEveryCorner() {
        std::mt19937 random(11);
        for (int round = 0; round < 200; ++round) {
            TriangleSoup soup;
            for (int i = 0; i < 9; ++i) {
                const double x = random() % 100, y = random() % 100;
                soup.positions.emplace_back(x, y, random() % 100);
            }
            for (int i = 0; i < 40; ++i) {
                const Index a = random() % 9, b = random() % 9;
                soup.triangles.push_back({a, b, Index(random() % 9)});
            }
            const auto found = normals(soup, 0);
            QCOMPARE(found.size(), 3 * soup.triangles.size());
            for (std::size_t i = 0; i < found.size(); ++i) {
                COMPARE_NEAR(found[i].norm(), 1, 1e-4, "");
                const auto& t = soup.triangles[i / 3];
                const bool flat = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
                if (!flat)
                    COMPARE_NEAR(found[i].cast<double>(), faceNormal(soup, i / 3), 1e-6,
                                 ""); // every edge is a crease at angle 0
            }
        }
    }

    void cancellingStops() {
        const std::atomic<bool> cancelled = true;
        QVERIFY(!cornerNormalsOf(cube(), 1, Progress{{}, &cancelled}));
    }
};

TACTUM_TEST(TestTopology)

} // namespace test_topology

#include "test_topology.moc"
