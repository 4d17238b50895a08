// Corner normals of any soup, held against a flood without any structure, and of closed meshes against
// OpenMesh.
#include <cmath>
#include <deque>
#include <optional>
#include <random>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <QTest>

#include "core/geometry/corner_normals.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_corner_normals {

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

/// By the words of the header alone, corner by corner: whoever shares an edge that is smooth belongs to it.
Vec3 floodedNormal(const TriangleSoup& soup, std::size_t corner, double crease) {
    const auto at = [&](std::size_t c) { return soup.positions[soup.triangles[c / 3][c % 3]]; };
    const auto next = [](std::size_t c) { return c - c % 3 + (c + 1) % 3; };
    const auto hasArea = [&](std::size_t t) {
        return at(3 * t) != at(3 * t + 1) && at(3 * t + 1) != at(3 * t + 2) && at(3 * t + 2) != at(3 * t);
    };
    const Vec3 here = at(corner);
    if (!hasArea(corner / 3)) return Vec3::UnitZ();
    // The corners across the edge that begins at c: one of the opposite direction, and no other.
    const auto across = [&](std::size_t c) {
        std::vector<std::size_t> opposite;
        int others = 0;
        for (std::size_t d = 0; d < 3 * soup.triangles.size(); ++d) {
            if (d == c || !hasArea(d / 3)) continue;
            if (at(d) == at(next(c)) && at(next(d)) == at(c))
                opposite.push_back(d);
            else if (at(d) == at(c) && at(next(d)) == at(next(c)))
                ++others;
        }
        const bool one = opposite.size() == 1 && others == 0;
        const bool smooth =
            one && faceNormal(soup, c / 3).dot(faceNormal(soup, opposite[0] / 3)) >= std::cos(crease);
        return smooth ? std::optional(opposite[0]) : std::nullopt;
    };
    std::deque<std::size_t> open{corner};
    std::vector<std::size_t> fan{corner};
    const auto add = [&](std::size_t c) {
        if (std::ranges::find(fan, c) == fan.end()) fan.push_back(c), open.push_back(c);
    };
    for (; !open.empty(); open.pop_front()) {
        const std::size_t c = open.front();
        if (const auto d = across(c)) add(next(*d));
        if (const auto d = across(next(next(c)))) add(*d);
    }
    Vec3 sum = Vec3::Zero();
    for (std::size_t c : fan) {
        const Vec3 a = (at(next(c)) - here).normalized(), b = (at(next(next(c))) - here).normalized();
        sum += std::acos(std::clamp(a.dot(b), -1.0, 1.0)) * faceNormal(soup, c / 3);
    }
    // Two sides of one sheet cancel each other: then each keeps its own.
    return sum.norm() > 1e-6 ? sum.normalized() : faceNormal(soup, corner / 3);
}

/// A closed mesh of two sizes of triangles, bumpy everywhere.
TriangleSoup torus(Index around, Index across) {
    TriangleSoup soup;
    for (Index i = 0; i < around; ++i)
        for (Index j = 0; j < across; ++j) {
            const double u = 2 * M_PI * i / around, v = 2 * M_PI * j / across;
            const double r = 1 + 0.2 * std::sin(3 * u + 2 * v);
            soup.positions.emplace_back((3 + r * std::cos(v)) * std::cos(u),
                                        (3 + r * std::cos(v)) * std::sin(u), r * std::sin(v));
            const Index a = i * across + j, b = (i + 1) % around * across + j,
                        c = (i + 1) % around * across + (j + 1) % across, d = i * across + (j + 1) % across;
            soup.triangles.push_back({a, b, c});
            soup.triangles.push_back({a, c, d});
        }
    return soup;
}

} // namespace

class TestCornerNormals : public QObject {
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

    /// Wrong itself if the flood took in what the header does not say: then the cubes above would fail.
    void randomSoupsAreAsFlooded() {
        std::mt19937 random(5);
        int joined = 0;
        for (int round = 0; round < 300; ++round) {
            TriangleSoup soup;
            for (int i = 0; i < 12; ++i) {
                const double x = random() % 100, y = random() % 100;
                soup.positions.emplace_back(x, y, random() % 100);
            }
            for (int i = 0; i < 30; ++i) {
                const Index a = random() % 6, b = random() % 6;
                soup.triangles.push_back({a, b, Index(random() % 6)});
            }
            const double crease = round % 3 == 0 ? M_PI : 0.02 * double(random() % 150);
            const auto found = normals(soup, crease);
            for (std::size_t i = 0; i < found.size(); ++i) {
                const Vec3 expected = floodedNormal(soup, i, crease);
                COMPARE_NEAR(found[i].cast<double>(), expected, 1e-5, "");
                joined += (found[i].cast<double>() - faceNormal(soup, i / 3)).norm() > 1e-3;
            }
        }
        QCOMPARE_GT(joined, 1000);
    }

    void aClosedMeshIsAsOpenMeshSays() {
        const TriangleSoup soup = torus(40, 23);
        OpenMesh::TriMesh_ArrayKernelT<> mesh;
        std::vector<OpenMesh::VertexHandle> vertex;
        for (const Vec3& p : soup.positions)
            vertex.push_back(mesh.add_vertex({float(p.x()), float(p.y()), float(p.z())}));
        for (const auto& t : soup.triangles)
            mesh.add_face(vertex[t[0]], vertex[t[1]], vertex[t[2]]);
        const auto found = normals(soup, M_PI);
        for (std::size_t i = 0; i < found.size(); ++i) {
            OpenMesh::Vec3f sum(0, 0, 0);
            for (auto h : mesh.vih_range(vertex[soup.triangles[i / 3][i % 3]]))
                sum += mesh.calc_sector_angle(h) * mesh.calc_face_normal(mesh.face_handle(h));
            sum.normalize();
            COMPARE_NEAR(found[i].cast<double>(), Vec3(sum[0], sum[1], sum[2]), 1e-5, "");
        }
    }

    void cancellingStops() {
        const std::atomic<bool> cancelled = true;
        QVERIFY(!cornerNormalsOf(cube(), 1, Progress{{}, &cancelled}));
    }
};

TACTUM_TEST(TestCornerNormals)

} // namespace test_corner_normals

#include "test_corner_normals.moc"
