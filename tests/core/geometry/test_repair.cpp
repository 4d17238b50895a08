// Repairs: what they repair, that they leave a sound mesh alone, and that doing it twice is doing it once.
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <set>

#include <QTest>

#include "core/geometry/closed.h"
#include "core/geometry/mesh_health.h"
#include "core/geometry/repair.h"
#include "core/geometry/weld.h"
#include "tests/core/geometry/meshes.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_repair {

using namespace tactum;
using namespace tactum::test;

namespace {

SharedSoup shared(TriangleSoup soup) {
    return std::make_shared<const TriangleSoup>(std::move(soup));
}

Vec3 areaVector(const TriangleSoup& soup, std::size_t t) {
    const auto& c = soup.triangles[t];
    const Vec3& a = soup.positions[c[0]];
    return 0.5 * (soup.positions[c[1]] - a).cross(soup.positions[c[2]] - a);
}

double area(const TriangleSoup& soup) {
    double sum = 0;
    for (std::size_t t = 0; t < soup.triangles.size(); ++t)
        sum += areaVector(soup, t).norm();
    return sum;
}

double volume(const TriangleSoup& soup) {
    double sum = 0;
    for (std::size_t t = 0; t < soup.triangles.size(); ++t)
        sum += soup.positions[soup.triangles[t][0]].dot(areaVector(soup, t)) / 3;
    return sum;
}

/// Vertices minus edges plus faces: 2 for a ball, 0 for a ring.
long euler(const TriangleSoup& soup) {
    const std::vector<Index> weld = weldMap(soup.positions);
    std::set<Index> vertices;
    std::set<std::pair<Index, Index>> edges;
    for (const auto& c : soup.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const Index a = weld[c[i]], b = weld[c[(i + 1) % 3]];
            vertices.insert(a);
            edges.emplace(std::min(a, b), std::max(a, b));
        }
    return long(vertices.size()) - long(edges.size()) + long(soup.triangles.size());
}

/// A ring around z, n by n squares.
TriangleSoup ring(Index n) {
    TriangleSoup soup;
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j) {
            const double u = 2 * M_PI * i / n, v = 2 * M_PI * j / n;
            soup.positions.emplace_back((2 + std::cos(v)) * std::cos(u), (2 + std::cos(v)) * std::sin(u),
                                        std::sin(v));
        }
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j) {
            const auto at = [&](Index k, Index l) { return (i + k) % n * n + (j + l) % n; };
            soup.triangles.push_back({at(0, 0), at(1, 0), at(1, 1)});
            soup.triangles.push_back({at(0, 0), at(1, 1), at(0, 1)});
        }
    soup.surfaceOf.assign(soup.triangles.size(), 0);
    return soup;
}

/// With normals, texture coordinates and surfaces that tell every corner from every other.
TriangleSoup dressed(TriangleSoup soup) {
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        soup.surfaceOf[t] = Index(t / 2);
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 p = soup.positions[soup.triangles[t][i]];
            soup.cornerNormals.push_back(areaVector(soup, t).normalized().cast<float>());
            soup.cornerUvs.emplace_back(float(p.x() + 2 * p.z()), float(p.y() + 4 * p.z()));
        }
    }
    return soup;
}

/// What corners carry still fits: the texture coordinates of dressed() are a function of the place.
bool isStillDressed(const TriangleSoup& soup, float tolerance = 1e-6f) {
    if (soup.cornerUvs.size() != 3 * soup.triangles.size() ||
        soup.cornerNormals.size() != 3 * soup.triangles.size() ||
        soup.surfaceOf.size() != soup.triangles.size())
        return false;
    for (std::size_t t = 0; t < soup.triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 p = soup.positions[soup.triangles[t][i]];
            const Eigen::Vector2f uv(float(p.x() + 2 * p.z()), float(p.y() + 4 * p.z()));
            if ((soup.cornerUvs[3 * t + i] - uv).norm() > tolerance) return false;
            if (soup.cornerNormals[3 * t + i].cast<double>().dot(areaVector(soup, t)) < 0) return false;
        }
    return true;
}

void turn(TriangleSoup& soup, std::size_t t) {
    std::swap(soup.triangles[t][1], soup.triangles[t][2]);
    if (soup.cornerUvs.empty()) return;
    std::swap(soup.cornerUvs[3 * t + 1], soup.cornerUvs[3 * t + 2]);
    for (std::size_t i = 3 * t; i < 3 * t + 3; ++i)
        soup.cornerNormals[i] *= -1;
}

void erase(TriangleSoup& soup, std::vector<Index> triangles) {
    std::ranges::sort(triangles, std::greater{});
    for (Index t : triangles) {
        soup.triangles.erase(soup.triangles.begin() + t);
        soup.surfaceOf.erase(soup.surfaceOf.begin() + t);
        if (soup.cornerUvs.empty()) continue;
        soup.cornerUvs.erase(soup.cornerUvs.begin() + 3 * t, soup.cornerUvs.begin() + 3 * t + 3);
        soup.cornerNormals.erase(soup.cornerNormals.begin() + 3 * t, soup.cornerNormals.begin() + 3 * t + 3);
    }
}

using Repair = std::function<Repaired(const SharedSoup&)>;
std::vector<Repair> repairs() {
    return {[](const SharedSoup& s) { return weldVertices(s).value(); },
            [](const SharedSoup& s) { return removeDuplicates(s).value(); },
            [](const SharedSoup& s) { return repairSlivers(s).value(); },
            [](const SharedSoup& s) { return agreeOnFronts(s).value(); },
            [](const SharedSoup& s) { return fillHoles(s).value(); },
            [](const SharedSoup& s) { return scaled(s, 1); }};
}

} // namespace

class TestMend : public QObject {
    Q_OBJECT

private slots:
    void aSoundMeshIsLeftAlone() {
        for (const TriangleSoup& soup : {cube(), dressed(cube()), ring(12), TriangleSoup{}}) {
            const SharedSoup before = shared(soup);
            for (const Repair& repair : repairs()) {
                const Repaired after = repair(before);
                QCOMPARE(after.soup.get(), before.get());
                QCOMPARE(after.changes, std::size_t(0));
                QVERIFY(!after.done.empty());
            }
        }
    }

    /// Of any soup: valid, and the second time there is nothing left to do.
    void twiceIsOnce() {
        std::mt19937 random(21);
        for (int round = 0; round < 400; ++round) {
            const SharedSoup soup = shared(dressed(tangle(random, Index(random() % 40))));
            for (std::size_t i = 0; i < repairs().size(); ++i) {
                const Repaired once = repairs()[i](soup), twice = repairs()[i](once.soup);
                const TriangleSoup& found = *once.soup;
                QVERIFY2(twice.soup == once.soup, qPrintable(QString::number(i)));
                QCOMPARE(found.surfaceOf.size(), found.triangles.size());
                QCOMPARE(found.cornerNormals.size(), 3 * found.triangles.size());
                QCOMPARE(found.cornerUvs.size(), 3 * found.triangles.size());
                for (const auto& c : found.triangles)
                    QCOMPARE_LT(std::ranges::max(c), found.positions.size());
            }
        }
    }

    void weldingKeepsTheShapeAndWhatCornersCarry() {
        TriangleSoup split = apart(dressed(cube()));
        split.positions.emplace_back(7, 7, 7);
        const Repaired welded = weldVertices(shared(split)).value();
        QCOMPARE(welded.soup->positions.size(), std::size_t(8));
        QCOMPARE(welded.changes, std::size_t(29));
        QCOMPARE(volume(*welded.soup), 1.0);
        QVERIFY(isStillDressed(*welded.soup));
    }

    void onlyRealDoublesGo() {
        TriangleSoup soup = dressed(cube());
        const auto repeat = [&](std::size_t t, std::array<std::size_t, 3> order, Index surface) {
            soup.surfaceOf.push_back(surface);
            const auto corners = soup.triangles[t];
            soup.triangles.push_back({corners[order[0]], corners[order[1]], corners[order[2]]});
            for (std::size_t i : order) {
                soup.cornerUvs.push_back(soup.cornerUvs[3 * t + i]);
                soup.cornerNormals.push_back(soup.cornerNormals[3 * t + i]);
            }
        };
        const TriangleSoup sound = soup;
        repeat(4, {1, 2, 0}, 2); // the same once more
        repeat(4, {0, 2, 1}, 2); // looks to the other way
        repeat(4, {0, 1, 2}, 5); // feels otherwise
        const Repaired repaired = removeDuplicates(shared(soup)).value();
        QCOMPARE(repaired.changes, std::size_t(1));
        QCOMPARE(repaired.soup->triangles.size(), std::size_t(14));
        TriangleSoup expected = sound;
        repeat(4, {0, 2, 1}, 2);
        QCOMPARE(repaired.soup->triangles[12], soup.triangles[13]);
        QCOMPARE(repaired.soup->surfaceOf[13], Index(5));
        QCOMPARE(repaired.soup->cornerUvs[36], soup.cornerUvs[39]);
    }

    void flippedTrianglesAreTurnedBack() {
        for (const TriangleSoup& sound : {dressed(cube()), dressed(ring(9))}) {
            TriangleSoup soup = sound;
            for (Index t : {1u, 4u, 5u})
                turn(soup, t);
            const Repaired repaired = agreeOnFronts(shared(soup)).value();
            QCOMPARE(repaired.changes, std::size_t(3));
            QVERIFY(*repaired.soup == sound);
            QCOMPARE(repaired.done, std::string("3 triangles turned over"));
        }
    }

    void theFrontOfAClosedMeshIsOutside() {
        TriangleSoup soup = dressed(cube());
        const TriangleSoup sound = soup;
        for (std::size_t t = 0; t < 12; ++t)
            turn(soup, t);
        QVERIFY(*agreeOnFronts(shared(soup)).value().soup == sound);
        turn(soup, 3); // eleven of twelve look inward
        QVERIFY(*agreeOnFronts(shared(soup)).value().soup == sound);
        QVERIFY(*turnOver(turnOver(shared(sound)).soup).soup == sound);
        QCOMPARE(volume(*turnOver(shared(sound)).soup), -1.0);
    }

    /// In an open mesh the smaller area gives way; a strip with one side has no front.
    void openMeshesAgreeAndMoebiusStripsStay() {
        TriangleSoup sheet = grid(5, [](double x, double y) { return x * y; });
        TriangleSoup soup = sheet;
        for (Index t : {0u, 3u, 4u, 20u}) // the first among them: it is no measure
            turn(soup, t);
        QVERIFY(*agreeOnFronts(shared(soup)).value().soup == sheet);

        TriangleSoup strip;
        const Index n = 12;
        for (Index i = 0; i < n; ++i) {
            const double turn = 2 * M_PI * i / n, twist = M_PI * i / n;
            const Vec3 out(std::cos(turn), std::sin(turn), 0);
            const Vec3 across = std::cos(twist) * Vec3::UnitZ() + std::sin(twist) * out;
            strip.positions.push_back(3 * out + across);
            strip.positions.push_back(3 * out - across);
        }
        for (Index i = 0; i < n; ++i) {
            const bool last = i + 1 == n; // joined upside down
            const Index a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
            strip.triangles.push_back({a, b, d});
            strip.triangles.push_back({a, d, c});
        }
        strip.surfaceOf.assign(strip.triangles.size(), 0);
        const SharedSoup before = shared(strip);
        QCOMPARE(agreeOnFronts(before).value().soup.get(), before.get());
    }

    void theLidOfABoxIsBack() {
        for (const bool split : {false, true}) {
            TriangleSoup soup = dressed(cube());
            erase(soup, {2, 3});
            if (split) soup = apart(soup);
            const Repaired repaired = fillHoles(shared(soup)).value();
            QCOMPARE(repaired.changes, std::size_t(1));
            QCOMPARE(repaired.soup->triangles.size(), std::size_t(12));
            QVERIFY(isClosed(*repaired.soup));
            QCOMPARE(euler(*repaired.soup), 2L);
            QCOMPARE(volume(*repaired.soup), 1.0);
            QVERIFY(isStillDressed(*repaired.soup));
        }
    }

    void severalHolesNextToEachOther() {
        TriangleSoup soup = ring(16);
        erase(soup, {0, 1, 40, 41, 42, 43, 100, 300});
        const Repaired repaired = fillHoles(shared(soup)).value();
        QCOMPARE(repaired.changes, std::size_t(4));
        QVERIFY(isClosed(*repaired.soup));
        QCOMPARE(euler(*repaired.soup), 0L);
        COMPARE_NEAR(volume(*repaired.soup) / volume(ring(16)), 1, 0.01, "");
    }

    /// A saddle of a hole: no plane holds it.
    void aCurvedHoleGetsASmallLid() {
        TriangleSoup soup = ring(24);
        std::vector<Index> patch;
        for (Index i = 0; i < 4; ++i)
            for (Index j = 0; j < 4; ++j)
                for (Index k = 0; k < 2; ++k)
                    patch.push_back(2 * (i * 24 + j) + k);
        erase(soup, patch);
        const Repaired repaired = fillHoles(shared(soup)).value();
        QVERIFY(isClosed(*repaired.soup));
        QCOMPARE(euler(*repaired.soup), 0L);
        QCOMPARE_LT(area(*repaired.soup), area(ring(24)));
        QCOMPARE_GT(area(*repaired.soup), 0.95 * area(ring(24)));
    }

    void whatIsMeantToBeOpenStaysOpen() {
        const SharedSoup sheet = shared(grid(6, [](double x, double y) { return x * y; }));
        QCOMPARE(fillHoles(sheet).value().soup.get(), sheet.get());
        TriangleSoup pierced = *sheet;
        erase(pierced, {28, 29});
        QCOMPARE(fillHoles(shared(pierced)).value().soup->triangles.size(), sheet->triangles.size());
        TriangleSoup alone;
        alone.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        alone.triangles = {{0, 1, 2}};
        alone.surfaceOf = {0};
        QCOMPARE(fillHoles(shared(alone)).value().changes, std::size_t(0));
        TriangleSoup box = cube();
        erase(box, {2, 3});
        QCOMPARE(fillHoles(shared(box), {.edges = 3}).value().changes, std::size_t(0));
        QCOMPARE(fillHoles(shared(box), {.area = 0.1}).value().changes, std::size_t(0));
    }

    /// The lid of the top makes the bottom a smaller part of the box, small enough then.
    void oneLidLetsAnotherFollow() {
        TriangleSoup soup = cube();
        erase(soup, {0, 1, 2});
        const HoleLimits limits{.area = 0.17}; // between 1 of 5.5 and 1 of 6
        const Repaired repaired = fillHoles(shared(soup), limits).value();
        QCOMPARE(repaired.changes, std::size_t(2));
        QVERIFY(isClosed(*repaired.soup));
    }

    /// Two holes that meet in a corner: which rim goes on into which nobody can say.
    void aRimThatMeetsItselfIsLeftOpen() {
        TriangleSoup soup = cube();
        erase(soup, {0, 10}); // share the corner 3 alone
        const SharedSoup before = shared(soup);
        QCOMPARE(fillHoles(before).value().soup.get(), before.get());
    }

    /// A vertex moved close to another: two needles, which go with it.
    void needlesGoWithTheirShortEdge() {
        TriangleSoup soup = ring(10);
        soup.positions[23] = soup.positions[24] + Vec3(1e-13, 0, 1e-13);
        soup = dressed(soup);
        const std::size_t slivers = healthOf(soup).value().slivers;
        QCOMPARE_GT(slivers, 0);
        const Repaired repaired = repairSlivers(shared(soup)).value();
        QCOMPARE(healthOf(*repaired.soup).value().slivers, std::size_t(0));
        QCOMPARE(repaired.soup->triangles.size(), soup.triangles.size() - 2);
        QVERIFY(isClosed(*repaired.soup));
        QCOMPARE(euler(*repaired.soup), 0L);
        COMPARE_NEAR(volume(*repaired.soup), volume(soup), 1e-9, "m³");
        QVERIFY(isStillDressed(*repaired.soup));
    }

    /// A vertex in the middle of an edge, of one side of it alone.
    void theLongEdgeOfACapIsTurned() {
        TriangleSoup soup = cube();
        soup.positions.emplace_back(0.5, 0.5, 1 + 1e-13);
        soup.triangles[2] = {4, 5, 8}; // the top's first triangle (4, 5, 7) cut at the middle of 4-7
        soup.triangles.push_back({5, 7, 8});
        soup.triangles.push_back({4, 8, 7}); // the cap: its long edge is the one of (4, 7, 6)
        soup.surfaceOf.assign(14, 0);
        soup = dressed(soup);
        QVERIFY(isClosed(soup));
        QCOMPARE(healthOf(soup).value().slivers, std::size_t(1));
        const Repaired repaired = repairSlivers(shared(soup)).value();
        QCOMPARE(repaired.changes, std::size_t(1));
        QCOMPARE(healthOf(*repaired.soup).value().slivers, std::size_t(0));
        QCOMPARE(repaired.soup->triangles.size(), std::size_t(14));
        QVERIFY(isClosed(*repaired.soup));
        QCOMPARE(euler(*repaired.soup), 2L);
        COMPARE_NEAR(volume(*repaired.soup), 1, 1e-12, "m³");
        QVERIFY(isStillDressed(*repaired.soup));
    }

    /// A three-sided tube, bent to a ring and pinched to nothing at one place: an edge less there, and it
    /// would be a ball.
    void aSliverThatHoldsTheTopologyStays() {
        TriangleSoup soup;
        const Index n = 8;
        for (Index i = 0; i < n; ++i)
            for (Index j = 0; j < 3; ++j) {
                const double u = 2 * M_PI * i / n, v = 2 * M_PI * j / 3, r = i == 0 ? 1e-13 : 0.5;
                soup.positions.emplace_back((2 + r * std::cos(v)) * std::cos(u),
                                            (2 + r * std::cos(v)) * std::sin(u), r * std::sin(v));
            }
        for (Index i = 0; i < n; ++i)
            for (Index j = 0; j < 3; ++j) {
                const auto at = [&](Index k, Index l) { return (i + k) % n * 3 + (j + l) % 3; };
                soup.triangles.push_back({at(0, 0), at(1, 0), at(1, 1)});
                soup.triangles.push_back({at(0, 0), at(1, 1), at(0, 1)});
            }
        soup.surfaceOf.assign(soup.triangles.size(), 0);
        QCOMPARE_GT(healthOf(soup).value().slivers, 0);
        const Repaired repaired = repairSlivers(shared(soup)).value();
        QVERIFY(isClosed(*repaired.soup));
        QCOMPARE(euler(*repaired.soup), 0L);
        QVERIFY(healthOf(*repaired.soup).value().closed());
    }

    void scalingScalesLengthsAlone() {
        const TriangleSoup soup = dressed(cube());
        const Repaired small = scaled(shared(soup), 0.001);
        COMPARE_NEAR(volume(*small.soup), 1e-9, 1e-20, "m³");
        QCOMPARE(small.soup->cornerUvs, soup.cornerUvs);
    }

    void cancellingStops() {
        const std::atomic<bool> cancelled = true;
        const Progress progress{{}, &cancelled};
        const SharedSoup soup = shared(cube());
        QVERIFY(!weldVertices(soup, progress));
        QVERIFY(!removeDuplicates(soup, progress));
        QVERIFY(!repairSlivers(soup, progress));
        QVERIFY(!agreeOnFronts(soup, progress));
        QVERIFY(!fillHoles(soup, {}, progress));
    }
};

TACTUM_TEST(TestMend)

} // namespace test_repair

#include "test_repair.moc"
