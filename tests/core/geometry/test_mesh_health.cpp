// Each count of the examination, on meshes where it is known.
#include <QTest>

#include "core/geometry/mesh_health.h"
#include "core/geometry/weld.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_mesh_health {

using namespace tactum;

namespace {

TriangleSoup cube() {
    TriangleSoup soup;
    for (int i = 0; i < 8; ++i)
        soup.positions.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
    soup.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return soup;
}

/// Every triangle with three vertices of its own, as STL has them.
TriangleSoup apart(const TriangleSoup& soup) {
    TriangleSoup result;
    for (const auto& t : soup.triangles) {
        const Index first = Index(result.positions.size());
        for (Index corner : t)
            result.positions.push_back(soup.positions[corner]);
        result.triangles.push_back({first, first + 1, first + 2});
    }
    return result;
}

MeshHealth health(const TriangleSoup& soup) {
    return healthOf(soup).value();
}

} // namespace

class TestMeshHealth : public QObject {
    Q_OBJECT

private slots:
    void aCubeIsClosed() {
        for (const TriangleSoup& soup : {cube(), apart(cube())}) {
            MeshHealth expected;
            expected.triangles = 12;
            expected.components = 1;
            QVERIFY(health(soup) == expected);
            QVERIFY(health(soup).closed());
        }
    }

    void holesAreGroupsOfOpenEdges() {
        TriangleSoup soup = cube();
        soup.triangles.erase(soup.triangles.begin() + 2, soup.triangles.begin() + 4); // the top
        soup.triangles.erase(soup.triangles.begin());                                 // half of the bottom
        QCOMPARE(health(soup).boundaryEdges, std::size_t(7));
        QCOMPARE(health(soup).holes, std::size_t(2));
        QVERIFY(!health(soup).closed());
    }

    void aTriangleTurnedOverDisagreesWithItsNeighbours() {
        TriangleSoup soup = cube();
        std::swap(soup.triangles[5][1], soup.triangles[5][2]);
        QCOMPARE(health(soup).flippedEdges, std::size_t(3));
        QVERIFY(!health(soup).closed());
    }

    void aWallInsideMakesNonManifoldEdges() {
        TriangleSoup soup = cube();
        soup.triangles.push_back({0, 3, 7}); // three edges that were whole
        const MeshHealth found = health(soup);
        QCOMPARE(found.nonManifoldEdges, std::size_t(2)); // 0-3 and 3-7
        QCOMPARE(found.boundaryEdges, std::size_t(1));    // 7-0
    }

    void duplicatesCountWhateverTheirOrder() {
        TriangleSoup soup = cube();
        soup.triangles.push_back({3, 0, 2});
        soup.triangles.push_back({3, 2, 0});
        QCOMPARE(health(soup).duplicateFaces, std::size_t(2));
        QCOMPARE(health(apart(soup)).duplicateFaces, std::size_t(2));
    }

    void partsAndSpareVerticesAreCounted() {
        TriangleSoup soup = cube();
        const TriangleSoup other = cube();
        for (const Vec3& p : other.positions)
            soup.positions.push_back(p + Vec3(5, 0, 0));
        for (auto t : other.triangles)
            soup.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
        soup.positions.emplace_back(9, 9, 9);
        QCOMPARE(health(soup).components, std::size_t(2));
        QCOMPARE(health(soup).unreferencedVertices, std::size_t(1));
    }

    void segmentsPointsAndSliversAreNoHoles() {
        TriangleSoup soup = cube();
        soup.positions.emplace_back(1e-13, 0, 0);
        soup.triangles.push_back({0, 7, 7});
        soup.triangles.push_back({3, 3, 3});
        soup.triangles.push_back({0, 8, 7});
        const MeshHealth found = health(soup);
        QCOMPARE(found.triangles, std::size_t(13));
        QCOMPARE(found.segments, std::size_t(1));
        QCOMPARE(found.points, std::size_t(1));
        QCOMPARE(found.slivers, std::size_t(1));
        QCOMPARE(found.boundaryEdges, std::size_t(3)); // those of the sliver
    }

    void flatTrianglesBecomeWhatTheyCover() {
        TriangleSoup soup;
        soup.positions = {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1e-9, 0}};
        soup.triangles = {{0, 1, 2}, {1, 4, 1}, {0, 1, 3}, {1, 3, 4}, {0, 2, 5}};
        for (std::size_t i = 0; i < 15; ++i)
            soup.cornerUvs.emplace_back(float(i), 0.f);
        const CollapsedTriangles done = collapseFlatTriangles(soup);
        QCOMPARE(done.toSegments, std::size_t(2));
        QCOMPARE(done.toPoints, std::size_t(1));
        const std::vector<std::array<Index, 3>> expected{
            {2, 0, 0}, {1, 1, 1}, {0, 1, 3}, {1, 3, 3}, {0, 2, 5}};
        QCOMPARE(soup.triangles, expected);
        QCOMPARE(soup.cornerUvs[0].x(), 2.f); // what a corner carries goes with it
        QCOMPARE(soup.cornerUvs[1].x(), 0.f);
        const CollapsedTriangles again = collapseFlatTriangles(soup);
        QCOMPARE(again.toSegments + again.toPoints, std::size_t(0));
    }

    void weldingIsExactAndKeepsTheFirst() {
        const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {-0.0, 0, 0}, {1, 0, 1e-16}, {1, 0, 0}};
        QCOMPARE(weldMap(positions), (std::vector<Index>{0, 1, 0, 3, 1}));
    }

    void weldingManyPlacesFindsEachOne() {
        PlaceTable table;
        for (int round = 0; round < 2; ++round)
            for (Index i = 0; i < 50'000; ++i)
                QCOMPARE(table.numberOf({i % 37 * 0.1, i * 1e-3, -double(i)}), i);
    }

    void cancellingStops() {
        TriangleSoup soup = cube();
        while (soup.triangles.size() < 200000)
            soup.triangles.push_back(soup.triangles[soup.triangles.size() - 12]);
        const std::atomic<bool> cancelled = true;
        QVERIFY(!healthOf(soup, Progress{{}, &cancelled}));
    }
};

TACTUM_TEST(TestMeshHealth)

} // namespace test_mesh_health

#include "test_mesh_health.moc"
