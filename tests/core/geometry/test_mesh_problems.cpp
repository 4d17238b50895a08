// Where the problems of a mesh are: each on a mesh made for it, and the counts of the examination on any
// soup.
#include <algorithm>
#include <map>
#include <random>

#include <QTest>

#include "core/geometry/mesh_health.h"
#include "core/geometry/mesh_problems.h"
#include "tests/core/geometry/meshes.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_mesh_problems {

using namespace tactum;
using namespace tactum::test;

namespace {

std::map<ProblemKind, Problem> problems(const TriangleSoup& soup) {
    const auto shared = std::make_shared<const TriangleSoup>(soup);
    std::map<ProblemKind, Problem> found;
    const std::vector<Problem> all = problemsOf(FaceGraph::build(shared).value()).value();
    for (const Problem& problem : all)
        found[problem.kind] = problem;
    return found;
}

void turn(TriangleSoup& soup, std::size_t t) {
    std::swap(soup.triangles[t][1], soup.triangles[t][2]);
}

} // namespace

class TestMeshProblems : public QObject {
    Q_OBJECT

private slots:
    void aSoundMeshHasNone() {
        QVERIFY(problems(cube()).empty());
        QVERIFY(problems(apart(cube())).empty());
        QVERIFY(problems({}).empty());
    }

    void eachIsFoundAtItsPlace() {
        TriangleSoup soup = joined(joined(cube(), cube({10, 0, 0})), cube({20, 0, 0}));
        turn(soup, 17); // of the second
        for (std::size_t t = 24; t < 36; ++t)
            turn(soup, t); // the third
        soup.triangles.push_back(soup.triangles[17]);
        soup.surfaceOf.push_back(0);
        soup.triangles.erase(soup.triangles.begin() + 2);
        soup.surfaceOf.pop_back();
        auto found = problems(soup);
        QCOMPARE(found[ProblemKind::Hole].count, std::size_t(1));
        QCOMPARE(found[ProblemKind::Hole].triangles.size(), std::size_t(3));
        QCOMPARE_EQ(found[ProblemKind::Hole].centre, Vec3(0.5, 0.5, 0.5));
        QCOMPARE(found[ProblemKind::InsideOut].count, std::size_t(1));
        QCOMPARE(found[ProblemKind::InsideOut].triangles.front(), Index(23));
        QCOMPARE(found[ProblemKind::InsideOut].centre.x(), 20.5);
        QCOMPARE(found[ProblemKind::InsideOut].radius, std::sqrt(0.75));
        QCOMPARE(found[ProblemKind::Duplicate].triangles, (TriangleSet{35}));
        QVERIFY(!found.contains(ProblemKind::Flipped)); // its edges have three triangles now
        QVERIFY(!found.contains(ProblemKind::Sliver));
    }

    void flippedNeighboursAreOnBothSides() {
        TriangleSoup soup = cube();
        turn(soup, 5);
        const Problem found = problems(soup)[ProblemKind::Flipped];
        QCOMPARE(found.count, std::size_t(3));
        QCOMPARE(found.triangles.size(), std::size_t(4));
    }

    /// A hollow in a body looks inward and is right; the same in the open is inside out.
    void aHollowIsNotInsideOut() {
        TriangleSoup hollow = cube({1, 1, 1});
        for (std::size_t t = 0; t < 12; ++t)
            turn(hollow, t);
        TriangleSoup shell = cube();
        for (Vec3& p : shell.positions)
            p *= 3;
        QVERIFY(problems(joined(hollow, shell)).empty());
        QVERIFY(problems(joined(shell, hollow)).empty());
        QVERIFY(problems(joined(shell, cube({1, 1, 1}))).empty());
        QCOMPARE(problems(hollow)[ProblemKind::InsideOut].count, std::size_t(1));
    }

    void theListIsBounded() {
        const TriangleSoup sheet = grid(80, [](double, double) { return 0.0; });
        const Problem found = problems(joined(sheet, sheet))[ProblemKind::Duplicate];
        QCOMPARE(found.count, std::size_t(12800));
        QCOMPARE(found.triangles.size(), Problem::kMaxTriangles);
    }

    void countsAreThoseOfTheExamination() {
        std::mt19937 random(4);
        for (int round = 0; round < 500; ++round) {
            const TriangleSoup soup = tangle(random, Index(random() % 40));
            const MeshHealth health = healthOf(soup).value();
            auto found = problems(soup);
            QCOMPARE(found[ProblemKind::Hole].count, health.holes);
            QCOMPARE(found[ProblemKind::Flipped].count, health.flippedEdges);
            QCOMPARE(found[ProblemKind::Duplicate].count, health.duplicateFaces);
            QCOMPARE(found[ProblemKind::Sliver].count, health.slivers);
            for (const auto& [kind, problem] : found)
                QVERIFY(isTriangleSet(problem.triangles, soup.triangles.size()));
        }
    }
};

TACTUM_TEST(TestMeshProblems)

} // namespace test_mesh_problems

#include "test_mesh_problems.moc"
