// Splitting triangles off as a surface and merging surfaces undo each other.
#include <algorithm>
#include <random>

#include <QTest>

#include "core/geometry/surfaces.h"
#include "tests/core/geometry/meshes.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_surfaces {

using namespace tactum;
using namespace tactum::test;

class TestSurfaces : public QObject {
    Q_OBJECT

private slots:
    void splittingChangesTheSurfaceAlone() {
        const TriangleSoup soup = cube();
        TriangleSoup split = withSurface(soup, {2, 3}, 1);
        QCOMPARE(trianglesOf(split, 1), (TriangleSet{2, 3}));
        QCOMPARE(trianglesOf(split, 0).size(), std::size_t(10));
        split.surfaceOf = soup.surfaceOf;
        QVERIFY(split == soup);
    }

    void mergingLeavesNoHoles() {
        const std::array<Index, 3> merged{4, 1, 2};
        const MergedSurfaces result = mergeSurfaces(6, merged);
        QCOMPARE(result.newNumber, (std::vector<Index>{0, 1, 1, 2, 1, 3}));
        QCOMPARE(result.merged, Index(1));
        QCOMPARE(result.count, Index(4));
        QCOMPARE(mergeSurfaces(3, {}).newNumber, (std::vector<Index>{0, 1, 2}));
        QCOMPARE(mergeSurfaces(0, {}).count, Index(0));
    }

    void areasAddUp() {
        TriangleSoup soup = cube();
        soup.triangles.push_back({0, 1, 1}); // a segment has none
        soup.surfaceOf.push_back(0);
        COMPARE_NEAR(areaOf(soup, TriangleSet{2}), 0.5, 1e-12, "m^2");
        COMPARE_NEAR(areaOf(soup, inverted(soup, {})), 6, 1e-12, "m^2");
        QCOMPARE(areaOf(soup, {}), 0.0);
    }

    void splitThenMergedIsTheFirstSoup() {
        std::mt19937 random(5);
        for (int round = 0; round < 300; ++round) {
            const TriangleSoup soup = tangle(random, 1 + Index(random() % 60));
            const auto source = Index(random() % 4);
            TriangleSet part = trianglesOf(soup, source);
            std::erase_if(part, [&](Index) { return random() % 2 == 0; });
            const TriangleSoup split = withSurface(soup, part, 4);
            QCOMPARE(trianglesOf(split, 4), part);
            const std::array<Index, 2> both{4, source};
            const MergedSurfaces merged = mergeSurfaces(5, both);
            QCOMPARE(merged.count, Index(4));
            QVERIFY(renumbered(split, merged.newNumber) == soup);
        }
    }
};

TACTUM_TEST(TestSurfaces)

} // namespace test_surfaces

#include "test_surfaces.moc"
