// Which triangles are to be turned over: by the smaller area, and outermost bodies by their inside.
#include <cmath>
#include <numeric>

#include <QTest>

#include "core/geometry/orientation.h"
#include "tests/core/geometry/meshes.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_orientation {

using namespace tactum;
using namespace tactum::test;

namespace {

Orientation of(const TriangleSoup& soup) {
    return orientationOf(FaceGraph::build(std::make_shared<const TriangleSoup>(soup)).value(), {}).value();
}

TriangleSoup scaled(TriangleSoup soup, double by, const Vec3& to) {
    for (Vec3& p : soup.positions)
        p = by * p + to;
    return soup;
}

TriangleSoup insideOut(TriangleSoup soup) {
    for (auto& t : soup.triangles)
        std::swap(t[1], t[2]);
    return soup;
}

TriangleSet range(Index from, Index to) {
    TriangleSet set(to - from);
    std::iota(set.begin(), set.end(), from);
    return set;
}

/// A cube without its lid, 1.5 % of a cube of twelve triangles left open.
TriangleSoup openCube() {
    TriangleSoup soup = scaled(cube(), 4, {-1.5, -1.5, -1.5});
    soup.triangles.pop_back();
    soup.surfaceOf.pop_back();
    return soup;
}

} // namespace

class TestOrientation : public QObject {
    Q_OBJECT

private slots:
    void aSoundBodyStays() {
        QVERIFY(of(cube()).turned.empty());
        QVERIFY(of({}).turned.empty());
        QCOMPARE(of(cube()).insideOutPatches, 0u);
    }

    void theSmallerAreaIsTurned() {
        TriangleSoup soup = cube();
        std::swap(soup.triangles[5][0], soup.triangles[5][1]);
        Orientation found = of(soup);
        QCOMPARE(found.turned, TriangleSet{5});
        QVERIFY(found.insideOut.empty()); // it did not agree within itself
        soup = insideOut(cube());
        std::swap(soup.triangles[5][0], soup.triangles[5][1]);
        found = of(soup);
        QCOMPARE(found.turned.size(), 11u); // and then the whole of it, for its front was inside
        QVERIFY(found.insideOut.empty());
        // By area, and not by number: one large triangle against two small ones.
        TriangleSoup fan;
        fan.positions = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {1, -1, 0}, {-1, 1, 0}};
        fan.triangles = {{0, 1, 2}, {0, 1, 3}, {2, 0, 4}};
        fan.surfaceOf = {0, 0, 0};
        QCOMPARE(of(fan).turned, (TriangleSet{1, 2}));
    }

    void aBodyInsideOutIsTurnedWhole() {
        const Orientation found = of(insideOut(cube()));
        QCOMPARE(found.turned, range(0, 12));
        QCOMPARE(found.insideOut, range(0, 12));
        QCOMPARE(found.insideOutPatches, 1u);
        const Orientation two = of(joined(insideOut(cube()), insideOut(cube({3, 0, 0}))));
        QCOMPARE(two.turned, range(0, 24));
        QCOMPARE(two.insideOutPatches, 2u);
        const Orientation second = of(joined(cube(), insideOut(cube({3, 0, 0}))));
        QCOMPARE(second.turned, range(12, 24));
        QCOMPARE(second.insideOut, range(12, 24));
    }

    /// In a closed body either may be meant; in one that is open, or beside one, it is no hollow.
    void hollowsStay() {
        const TriangleSoup around = scaled(cube(), 4, {-1.5, -1.5, -1.5});
        QVERIFY(of(joined(around, insideOut(cube()))).turned.empty());
        QVERIFY(of(joined(insideOut(cube()), around)).turned.empty()); // whichever comes first
        const TriangleSoup open = openCube();
        QCOMPARE(of(joined(open, insideOut(cube()))).turned, range(11, 23));
        // In the box of another body, and outside of it: in the corner of a tetrahedron's box.
        TriangleSoup corner;
        corner.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}};
        corner.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
        corner.surfaceOf.assign(4, 0);
        const TriangleSoup small = insideOut(scaled(cube(), 0.5, {3.2, 3.2, 3.2}));
        QCOMPARE(of(joined(corner, small)).turned, range(4, 16));
        const TriangleSoup within = insideOut(scaled(cube(), 0.2, {0.3, 0.3, 0.3}));
        QVERIFY(of(joined(corner, within)).turned.empty());
        // A body that is itself turned over holds others as well.
        QCOMPARE(of(joined(insideOut(around), insideOut(cube()))).turned, range(0, 12));
    }

    /// A strip with half a twist has no two sides: nothing of it is turned, and nothing is held by it.
    void whatHasNoTwoSidesStays() {
        TriangleSoup strip;
        constexpr Index kParts = 24;
        for (Index i = 0; i < kParts; ++i) {
            const double turn = 2 * M_PI * i / kParts;
            const Vec3 middle(std::cos(turn), std::sin(turn), 0);
            const Vec3 across = std::cos(turn / 2) * middle + std::sin(turn / 2) * Vec3::UnitZ();
            strip.positions.push_back(middle - 0.3 * across);
            strip.positions.push_back(middle + 0.3 * across);
        }
        for (Index i = 0; i < kParts; ++i) {
            const bool last = i + 1 == kParts;
            const Index a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
            strip.triangles.push_back({a, c, b});
            strip.triangles.push_back({b, c, d});
        }
        strip.surfaceOf.assign(strip.triangles.size(), 0);
        QVERIFY(of(strip).turned.empty());
        QCOMPARE(of(joined(strip, insideOut(cube({5, 0, 0})))).turned, range(2 * kParts, 2 * kParts + 12));
    }

    void whatHasNoVolumeStays() {
        const TriangleSoup sheet = grid(3, [](double, double) { return 0.0; });
        QVERIFY(of(sheet).turned.empty());
        QVERIFY(of(insideOut(sheet)).turned.empty());
        TriangleSoup flat = scaled(cube(), 1, Vec3::Zero()); // closed, and of no thickness
        for (Vec3& p : flat.positions)
            p.z() = 0;
        QVERIFY(of(insideOut(flat)).insideOut.empty());
    }

    void cancellingStops() {
        const std::atomic<bool> cancelled = true;
        const TriangleSoup many = grid(300, [](double, double) { return 0.0; });
        const auto graph = FaceGraph::build(std::make_shared<const TriangleSoup>(many)).value();
        QVERIFY(!orientationOf(graph, {{}, &cancelled}));
    }
};

TACTUM_TEST(TestOrientation)

} // namespace test_orientation

#include "test_orientation.moc"
