// Parts out of reach, mistaken units, and the list of all that is the matter with a scene.
#include <algorithm>
#include <cmath>
#include <vector>

#include <QTest>

#include "core/health/examine.h"
#include "core/health/mesh_probe.h"
#include "tests/core/geometry/meshes.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_examine {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kRadius = 1e-3;

TriangleSoup box(const Vec3& low, const Vec3& size) {
    TriangleSoup soup = cube();
    for (Vec3& p : soup.positions)
        p = low + p.cwiseProduct(size);
    return soup;
}

FaceGraph graphOf(const TriangleSoup& soup) {
    return FaceGraph::build(std::make_shared<const TriangleSoup>(soup)).value();
}

Problem hidden(const TriangleSoup& soup, const std::vector<Sides>& sides = {}) {
    return unreachableParts(graphOf(soup), sides, kRadius).value();
}

void turnAll(TriangleSoup& soup) {
    for (auto& t : soup.triangles)
        std::swap(t[1], t[2]);
}

/// A shell of two boxes, the inner one turned to the hollow.
TriangleSoup hollowBox() {
    TriangleSoup inner = box({0.01, 0.01, 0.01}, {0.08, 0.08, 0.08});
    turnAll(inner);
    return joined(box({0, 0, 0}, {0.1, 0.1, 0.1}), inner);
}

Scene sceneOf(const TriangleSoup& soup) {
    Scene scene;
    SceneObject object;
    object.name = "thing";
    object.geometry = std::make_shared<const TriangleSoup>(soup);
    object.surfaces.resize(1);
    scene.add(std::move(object));
    return scene;
}

} // namespace

class TestExamine : public QObject {
    Q_OBJECT

private slots:
    void aHollowIsOutOfReach() {
        const TriangleSoup soup = hollowBox();
        const Problem found = hidden(soup);
        QCOMPARE(found.count, std::size_t(1));
        QCOMPARE(found.triangles.size(), std::size_t(12));
        QCOMPARE(found.triangles.front(), Index(12));
        QCOMPARE(hidden(joined(soup, box({0.03, 0.03, 0.03}, {0.01, 0.01, 0.01}))).count, std::size_t(2));
        QCOMPARE(hidden(box({0, 0, 0}, {1, 1, 1})).count, std::size_t(0));
        QCOMPARE(hidden({}).count, std::size_t(0));
    }

    /// A shell that is not felt from outside lets the proxy in; turned over, its back is outside.
    void sidesOpenAShell() {
        TriangleSoup soup = hollowBox();
        for (std::size_t t = 12; t < 24; ++t)
            soup.surfaceOf[t] = 1;
        QCOMPARE(hidden(soup, {Sides::Front, Sides::Both}).count, std::size_t(1));
        QCOMPARE(hidden(soup, {Sides::Back, Sides::Both}).count, std::size_t(0));
        turnAll(soup);
        QCOMPARE(hidden(soup, {Sides::Back, Sides::Both}).count, std::size_t(1));
        QCOMPARE(hidden(soup, {Sides::Front, Sides::Both}).count, std::size_t(0));
    }

    /// An opening as wide as the proxy makes it reachable, a narrower one does not.
    void openingsCountByTheirWidth() {
        for (const double width : {1e-3, 4e-3}) {
            TriangleSoup soup = hollowBox();
            const Vec3 a(0.05, 0.05, 0.1), b = a + Vec3(width, 0, 0), c = a + Vec3(0, width, 0);
            const Index first = Index(soup.positions.size());
            for (const Vec3& p : {a, b, c})
                soup.positions.push_back(p);
            // The top's triangle (4, 5, 7) around a hole (a, b, c).
            const Index i = first, j = first + 1, k = first + 2;
            soup.triangles[2] = {4, 5, j};
            soup.triangles.insert(soup.triangles.end(),
                                  {{4, j, i}, {5, 7, j}, {7, k, j}, {7, 4, k}, {4, i, k}});
            soup.surfaceOf.assign(soup.triangles.size(), 0);
            QCOMPARE(graphOf(soup).connected(0).size(), std::size_t(17));
            QCOMPARE(hidden(soup).count, std::size_t(width < 2e-3 / std::sqrt(2.0) ? 1 : 0));
        }
    }

    /// In the box of a shell, but outside of it: between the arms of an L.
    void aNicheIsNotInside() {
        TriangleSoup shell = cube(); // one corner pressed deep into the cube
        shell.positions[7] = Vec3(0.2, 0.2, 0.2);
        for (Vec3& p : shell.positions)
            p *= 0.1;
        QCOMPARE(hidden(joined(shell, box({0.08, 0.08, 0.08}, {0.005, 0.005, 0.005}))).count, std::size_t(0));
        QCOMPARE(hidden(joined(shell, box({0.005, 0.005, 0.005}, {0.004, 0.004, 0.004}))).count,
                 std::size_t(1));
    }

    void aMistakenUnitIsGuessed() {
        QVERIFY(!guessUnit(0.2));
        QVERIFY(!guessUnit(2));
        QVERIFY(!guessUnit(0.005));
        QVERIFY(!guessUnit(0));
        QCOMPARE(guessUnit(200)->factor, 0.001);
        QCOMPARE(guessUnit(8)->factor, 0.0254);
        QCOMPARE(guessUnit(2e-4)->factor, 1000.0);
        QVERIFY(!guessUnit(1e9));
    }

    void everythingIsInOneList() {
        TriangleSoup soup = box({0, 0, 0}, {0.1, 0.1, 0.1});
        std::swap(soup.triangles[5][1], soup.triangles[5][2]);
        soup.triangles.erase(soup.triangles.begin() + 2);
        soup.surfaceOf.pop_back();
        Scene scene = sceneOf(soup);
        const Examined first = examine(scene).value();
        QCOMPARE(first.findings.size(), std::size_t(2));
        const std::vector<Finding> said = validate(scene);
        for (std::size_t i = 0; i < 2; ++i) {
            const PlacedFinding& found = first.findings[i];
            QVERIFY(found.finding == said[i]);
            QCOMPARE(found.object, scene.objects[0].id);
            QVERIFY(saysHealth(found.finding));
            // Its own repair makes an end of it.
            const Repaired repaired = repair(scene.objects[0].geometry, found.repair).value();
            Scene after = scene;
            after.objects[0].geometry = repaired.soup;
            const Examined second = examine(after).value();
            for (const PlacedFinding& left : second.findings)
                QCOMPARE_NE(left.problem->kind, found.problem->kind);
        }
        QVERIFY(!saysHealth({Finding::Severity::Note, "thing", "is blue", "paint it"}));
    }

    void whatIsKnownIsNotLookedForAgain() {
        Scene scene = sceneOf(hollowBox());
        Examined first = examine(scene).value();
        QCOMPARE(first.meshes.size(), std::size_t(1));
        QCOMPARE(first.findings.back().problem->kind, ProblemKind::Unreachable);
        first.meshes[0].problems.clear(); // so that it shows
        QVERIFY(examine(scene, first.meshes)->findings.empty());
        scene.objects[0].surfaces[0].sides = Sides::Front;
        QVERIFY(examine(scene, first.meshes)->findings.back().problem.has_value());
    }

    void progressOnlyGoesOn() {
        Scene scene;
        for (const double size : {1.0, 1.1, 1.2, 1.3}) { // a mesh of its own each
            TriangleSoup soup = hollowBox();
            for (Vec3& p : soup.positions)
                p *= size;
            scene.add(SceneObject(sceneOf(soup).objects[0]));
        }
        std::vector<double> told;
        QVERIFY(examine(scene, {}, Progress{[&](double fraction) { told.push_back(fraction); }, nullptr}));
        QCOMPARE(told.size(), std::size_t(8)); // each has two shells
        QVERIFY(std::ranges::is_sorted(told));
        QCOMPARE_GT(told.front(), 0.0);
        QCOMPARE(told.back(), 1.0);
    }

    void cancellingStops() {
        const std::atomic<bool> cancelled = true;
        QVERIFY(!examine(sceneOf(hollowBox()), {}, Progress{{}, &cancelled}));
    }
};

TACTUM_TEST(TestExamine)

} // namespace test_examine

#include "test_examine.moc"
