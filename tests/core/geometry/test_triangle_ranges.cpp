// Sets of triangles as runs of numbers, and carried onto other forms of their mesh.
#include <QTest>

#include "core/geometry/repair.h"
#include "core/geometry/triangle_ranges.h"
#include "tests/core/geometry/meshes.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_triangle_ranges {

using namespace tactum;
using namespace tactum::test;

namespace {

SharedSoup shared(TriangleSoup soup) {
    return std::make_shared<const TriangleSoup>(std::move(soup));
}

TriangleSet carried(const TriangleSet& set, const TriangleSoup& before, const TriangleSoup& after) {
    return trianglesOf(carriedRanges(rangesOf(set), before, after));
}

const TriangleSet kSome{0, 1, 2, 5, 7, 8};

} // namespace

class TestTriangleRanges : public QObject {
    Q_OBJECT

private slots:
    void aSetHasOneForm() {
        const TriangleRanges ranges = rangesOf(kSome);
        QCOMPARE(ranges, (TriangleRanges{{0, 3}, {5, 6}, {7, 9}}));
        QCOMPARE(trianglesOf(ranges), kSome);
        QCOMPARE(countOf(ranges), kSome.size());
        QVERIFY2(areTriangleRanges(ranges, 9), "all nine are there");
        QVERIFY2(!areTriangleRanges(ranges, 8), "the last one is not there");
        QCOMPARE(rangesOf({}), TriangleRanges());
    }

    void otherFormsAreNone() {
        for (const TriangleRanges& wrong :
             {TriangleRanges{{3, 3}}, {{3, 2}}, {{0, 2}, {2, 3}}, {{4, 5}, {0, 1}}, {{0, 3}, {2, 5}}})
            QVERIFY2(!areTriangleRanges(wrong, 100), qPrintable(QString::number(wrong.front().first)));
    }

    void numbersStayWhereTheTrianglesDo() {
        const SharedSoup loose = shared(apart(cube()));
        const Result<Repaired> welded = weldVertices(loose);
        VERIFY_RESULT(welded);
        QCOMPARE_LT(welded->soup->positions.size(), loose->positions.size());
        QCOMPARE(carried(kSome, *loose, *welded->soup), kSome);
        QCOMPARE(carried(kSome, *loose, *turnOver(loose).soup), kSome);
    }

    /// Two triangles that are there twice go, and all behind them move up.
    void trianglesAreKnownByTheirPlaces() {
        TriangleSoup doubled = cube();
        doubled.triangles.insert(doubled.triangles.begin() + 4, {doubled.triangles[0], doubled.triangles[1]});
        doubled.surfaceOf.assign(14, 0);
        const Result<Repaired> repaired = removeDuplicates(shared(doubled));
        VERIFY_RESULT(repaired);
        QCOMPARE(repaired->soup->triangles.size(), 12u);
        QCOMPARE(carried({0, 6, 13}, doubled, *repaired->soup), (TriangleSet{0, 4, 11}));
    }

    void theLidOfAHoleIsInNoSet() {
        TriangleSoup open = cube();
        open.triangles.erase(open.triangles.begin() + 2, open.triangles.begin() + 4);
        open.surfaceOf.assign(10, 0);
        const Result<Repaired> closed = fillHoles(shared(open));
        VERIFY_RESULT(closed);
        QCOMPARE(closed->soup->triangles.size(), 12u);
        const TriangleSet all{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
        QCOMPARE(carried(all, open, *closed->soup).size(), 10u);
    }

    /// A sheet with a front on each side.
    void twinsAreToldApart() {
        TriangleSoup sheet = cube();
        sheet.triangles = {{0, 2, 3}, {4, 5, 7}, {0, 3, 2}};
        sheet.surfaceOf.assign(3, 0);
        TriangleSoup without = sheet;
        without.triangles.erase(without.triangles.begin() + 1);
        without.surfaceOf.assign(2, 0);
        QCOMPARE(carried({2}, sheet, without), (TriangleSet{1}));
        QCOMPARE(carried({0}, sheet, without), (TriangleSet{0}));
    }

    void nothingIsCarriedFromAPoint() {
        TriangleSoup point;
        point.positions = {Vec3::Zero()};
        point.triangles = {{0, 0, 0}};
        point.surfaceOf = {0};
        QCOMPARE(carried({0}, point, cube()), TriangleSet());
    }
};

TACTUM_TEST(TestTriangleRanges)

} // namespace test_triangle_ranges

#include "test_triangle_ranges.moc"
