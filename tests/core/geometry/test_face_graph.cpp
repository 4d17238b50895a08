// Neighbours and regions: closed forms, a slow answer for any soup, and what holds between regions.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include <QTest>

#include "core/geometry/face_graph.h"
#include "tests/core/geometry/meshes.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_face_graph {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kDegree = M_PI / 180;

FaceGraph graphOf(TriangleSoup soup) {
    return FaceGraph::build(std::make_shared<const TriangleSoup>(std::move(soup))).value();
}

TriangleSet all(std::size_t count) {
    TriangleSet set(count);
    std::iota(set.begin(), set.end(), Index{0});
    return set;
}

/// A tube around z with n sides of two triangles: 0 to 2 n - 1 its mantle, then two lids of n triangles.
TriangleSoup can(Index n) {
    TriangleSoup soup;
    for (double z : {0.0, 1.0})
        for (Index k = 0; k < n; ++k)
            soup.positions.emplace_back(std::cos(2 * M_PI * k / n), std::sin(2 * M_PI * k / n), z);
    soup.positions.emplace_back(0, 0, 0);
    soup.positions.emplace_back(0, 0, 1);
    for (Index k = 0; k < n; ++k) {
        const Index next = (k + 1) % n;
        soup.triangles.push_back({k, next, n + next});
        soup.triangles.push_back({k, n + next, n + k});
    }
    for (Index k = 0; k < n; ++k)
        soup.triangles.push_back({2 * n, (k + 1) % n, k});
    for (Index k = 0; k < n; ++k)
        soup.triangles.push_back({2 * n + 1, n + k, n + (k + 1) % n});
    soup.surfaceOf.assign(soup.triangles.size(), 0);
    return soup;
}

/// The same by comparing every triangle with every other.
class SlowGraph {
public:
    explicit SlowGraph(const TriangleSoup& soup) : soup_(soup) {
        for (Index t = 0; t < soup.triangles.size(); ++t)
            for (const Meeting& meeting : meetingsOf(t))
                uses_[meeting].push_back(t);
    }

    bool neighbours(Index a, Index b) const {
        for (const auto& [edge, uses] : uses_)
            if (a != b && contains(uses, a) && contains(uses, b)) return true;
        return false;
    }

    bool smooth(Index a, Index b, double angle) const {
        for (const auto& [edge, uses] : uses_)
            if (a != b && contains(uses, a) && contains(uses, b) && goesOn(edge, uses, a, b, angle))
                return true;
        return false;
    }

    bool similar(Index a, Index b, double angle) const {
        return hasNormal(a) && hasNormal(b) && between(normal(a), normal(b)) <= angle;
    }

    template <class Related> TriangleSet reached(Index seed, Related related) const {
        std::set<Index> found{seed};
        for (std::size_t before = 0; before != found.size();) {
            before = found.size();
            for (Index t : std::set<Index>(found))
                for (Index u = 0; u < soup_.triangles.size(); ++u)
                    if (related(t, u)) found.insert(u);
        }
        return {found.begin(), found.end()};
    }

private:
    using Place = std::array<double, 3>;
    using Meeting = std::set<Place>; ///< an edge, or the end of a segment

    Place place(Index t, std::size_t i) const {
        const Vec3& p = soup_.positions[soup_.triangles[t][i]];
        return {p.x(), p.y(), p.z()};
    }
    std::set<Place> places(Index t) const { return {place(t, 0), place(t, 1), place(t, 2)}; }
    std::vector<Meeting> meetingsOf(Index t) const {
        std::vector<Meeting> result;
        if (places(t).size() == 3)
            for (std::size_t i = 0; i < 3; ++i)
                result.push_back({place(t, i), place(t, (i + 1) % 3)});
        else
            for (const Place& p : places(t))
                result.push_back({p});
        return result;
    }
    static bool contains(const std::vector<Index>& uses, Index t) {
        return std::find(uses.begin(), uses.end(), t) != uses.end();
    }
    Vec3 normal(Index t) const {
        const auto& c = soup_.triangles[t];
        const Vec3& a = soup_.positions[c[0]];
        return (soup_.positions[c[1]] - a).cross(soup_.positions[c[2]] - a);
    }
    bool hasNormal(Index t) const { return normal(t).norm() > 0; }
    static double between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }
    bool forward(Index t, const Meeting& edge) const {
        for (std::size_t i = 0; i < 3; ++i)
            if (place(t, i) == *edge.begin() && place(t, (i + 1) % 3) == *edge.rbegin()) return true;
        return false;
    }
    bool goesOn(const Meeting& edge, const std::vector<Index>& uses, Index a, Index b, double angle) const {
        if (edge.size() == 1) return goesOnAtEnd(edge, uses, a, b, angle);
        if (uses.size() > FaceGraph::kMaxAround || !hasNormal(a) || !hasNormal(b)) return false;
        const bool agree = forward(a, edge) != forward(b, edge);
        if (uses.size() > 2 && !agree) return false;
        return between(normal(a), agree ? normal(b) : -normal(b)) <= angle;
    }
    bool goesOnAtEnd(const Meeting& end, const std::vector<Index>& uses, Index a, Index b,
                     double angle) const {
        if (uses.size() != 2 || places(a).size() != 2 || places(b).size() != 2) return false;
        const auto way = [&](Index t) {
            const std::set<Place> both = places(t);
            const Place &from = *end.begin(), &to = *both.begin() == from ? *both.rbegin() : *both.begin();
            return Vec3(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
        };
        return between(way(a), -way(b)) <= angle;
    }

    const TriangleSoup& soup_;
    std::map<Meeting, std::vector<Index>> uses_;
};

} // namespace

class TestFaceGraph : public QObject {
    Q_OBJECT

private slots:
    void aCubeHasSidesAndIsWhole() {
        for (const TriangleSoup& soup : {cube(), apart(cube())}) {
            const FaceGraph graph = graphOf(soup);
            for (Index t = 0; t < 12; ++t) {
                const Index first = t / 2 * 2;
                QCOMPARE(graph.smooth(t, 40 * kDegree), (TriangleSet{first, first + 1}));
                QCOMPARE(graph.smooth(t, 0), (TriangleSet{first, first + 1}));
                QCOMPARE(graph.smooth(t, 90 * kDegree), all(12));
                QCOMPARE(graph.connected(t), all(12));
                QCOMPARE(graph.similar(t, 0, true), (TriangleSet{first, first + 1}));
            }
        }
    }

    void aRoundMantleIsSmoothUpToItsRims() {
        const Index n = 36; // bends by 10 degrees
        const FaceGraph graph = graphOf(can(n));
        QCOMPARE(graph.smooth(5, 10.1 * kDegree), all(2 * n));
        QCOMPARE(graph.smooth(5, 9.9 * kDegree), (TriangleSet{4, 5}));
        QCOMPARE(graph.smooth(2 * n, 80 * kDegree).size(), std::size_t(n)); // a lid
        QCOMPARE(graph.smooth(2 * n, 91 * kDegree), all(4 * n));
    }

    void similarNormalsAreFoundFarAwayAsWell() {
        const FaceGraph graph = graphOf(joined(cube(), cube({5, 0, 0})));
        QCOMPARE(graph.similar(6, 1 * kDegree, false), (TriangleSet{6, 7, 18, 19}));
        QCOMPARE(graph.similar(6, 1 * kDegree, true), (TriangleSet{6, 7}));
        QCOMPARE(graph.similar(6, 180 * kDegree, false), all(24));
        QCOMPARE(graph.similar(6, 180 * kDegree, true), all(12));
    }

    /// Side by side, with both walls between them: 36 edges, four of which have four triangles.
    void touchingCubesShareTheirSmoothTop() {
        const FaceGraph graph = graphOf(joined(cube(), cube({1, 0, 0})));
        QCOMPARE(graph.smooth(2, 40 * kDegree), (TriangleSet{2, 3, 14, 15}));
        QCOMPARE(graph.connected(2), all(24));
    }

    /// Along one edge alone: their sides there lie in one plane, but look to opposite ways.
    void cubesThatTouchInAnEdgeStayTwo() {
        const FaceGraph graph = graphOf(joined(cube(), cube({1, 1, 0})));
        for (Index t = 0; t < 24; ++t)
            QCOMPARE(graph.smooth(t, 40 * kDegree).size(), std::size_t(2));
        QCOMPARE(graph.connected(0), all(24));
        QCOMPARE(graphOf(joined(cube(), cube({1, 1, 1}))).connected(0), all(12)); // in a corner
    }

    void flippedNeighboursBendAsTheyLookAndNotAsTheyAreWound() {
        TriangleSoup soup = cube();
        std::swap(soup.triangles[3][1], soup.triangles[3][2]);
        QCOMPARE(graphOf(soup).smooth(2, 1 * kDegree), (TriangleSet{2, 3}));
    }

    /// Every triangle a second time, turned over: as programs export what is to be seen from both sides.
    void aDoubleSheetHasTwoSmoothSides() {
        TriangleSoup soup = grid(4, [](double, double) { return 0.0; });
        TriangleSoup back = soup;
        for (auto& t : back.triangles)
            std::swap(t[1], t[2]);
        const FaceGraph graph = graphOf(joined(soup, back));
        QCOMPARE(graph.smooth(7, 10 * kDegree), all(32));
        QCOMPARE(graph.connected(7), all(64));
    }

    /// Pages around one edge, each opposite to another that goes on where it ends.
    void anEdgeOfTooManyIsACrease() {
        const auto book = [](Index pages) {
            TriangleSoup soup;
            soup.positions = {{0, 0, 0}, {0, 0, 1}};
            for (Index i = 0; i < pages; ++i) {
                const double turn = 2 * M_PI * i / pages;
                soup.positions.emplace_back(std::cos(turn), std::sin(turn), 0.5);
                soup.triangles.push_back({i < pages / 2 ? 0u : 1u, i < pages / 2 ? 1u : 0u, 2 + i});
            }
            soup.surfaceOf.assign(pages, 0);
            return graphOf(soup);
        };
        QCOMPARE(book(16).smooth(3, 5 * kDegree), (TriangleSet{3, 11}));
        QCOMPARE(book(18).smooth(3, 5 * kDegree), (TriangleSet{3}));
    }

    void segmentsFollowEachOther() {
        TriangleSoup soup = cube();
        for (double x : {2.0, 3.0, 4.0})
            soup.positions.emplace_back(x, 0, 0);
        soup.positions.emplace_back(4, 1, 0);
        soup.triangles.insert(soup.triangles.end(), {{8, 9, 9}, {10, 9, 9}, {10, 11, 11}, {11, 11, 11}});
        soup.surfaceOf.assign(16, 0);
        const FaceGraph graph = graphOf(soup);
        QCOMPARE(graph.connected(13), (TriangleSet{12, 13, 14, 15}));
        QCOMPARE(graph.smooth(13, 10 * kDegree), (TriangleSet{12, 13}));
        QCOMPARE(graph.smooth(13, 90 * kDegree), (TriangleSet{12, 13, 14}));
        QCOMPARE(graph.similar(13, 1, false), (TriangleSet{13}));
        QVERIFY(graph.outline({12, 13}).empty());
    }

    void anOutlineIsWhereTheSetEnds() {
        const FaceGraph graph = graphOf(cube());
        QCOMPARE(graph.outline({2, 3}).size(), std::size_t(4));
        QCOMPARE(graph.outline({2}).size(), std::size_t(3));
        QVERIFY(graph.outline(all(12)).empty());
        const FaceGraph open = graphOf(grid(3, [](double, double) { return 0.0; }));
        QCOMPARE(open.outline(all(18)).size(), std::size_t(12));
        // Of two cubes side by side one ends at all its edges that the other has too, each drawn once.
        const FaceGraph two = graphOf(joined(cube(), cube({1, 0, 0})));
        QCOMPARE(two.outline(all(12)).size(), std::size_t(5)); // with the diagonal, which both have
    }

    /// Against the slow answer: neighbours, all regions, and what holds between them.
    void randomSoupsAgreeWithTheSlowAnswer() {
        std::mt19937 random(7);
        for (int round = 0; round < 150; ++round) {
            const TriangleSoup soup = tangle(random, 4 + Index(random() % 30));
            const FaceGraph graph = graphOf(soup);
            const SlowGraph slow(soup);
            const double angle = kDegree * (double(random() % 180) + 0.5);
            const auto count = Index(soup.triangles.size());
            const auto seed = Index(random() % count);
            QCOMPARE(graph.connected(seed),
                     slow.reached(seed, [&](Index a, Index b) { return slow.neighbours(a, b); }));
            QCOMPARE(graph.smooth(seed, angle),
                     slow.reached(seed, [&](Index a, Index b) { return slow.smooth(a, b, angle); }));
            QCOMPARE(graph.similar(seed, angle, true), slow.reached(seed, [&](Index a, Index b) {
                return slow.neighbours(a, b) && slow.similar(seed, b, angle);
            }));
            TriangleSet similar{seed}, ring{seed};
            for (Index t = 0; t < count; ++t) {
                if (t != seed && slow.similar(seed, t, angle)) similar.push_back(t);
                if (slow.neighbours(seed, t)) ring.push_back(t);
            }
            std::ranges::sort(similar);
            std::ranges::sort(ring);
            QCOMPARE(graph.similar(seed, angle, false), similar);
            QCOMPARE(graph.grown({seed}), ring);
        }
    }

    void regionsPartAMeshAndFitIntoEachOther() {
        std::mt19937 random(8);
        for (int round = 0; round < 200; ++round) {
            const FaceGraph graph = graphOf(tangle(random, 1 + Index(random() % 60)));
            const auto count = Index(graph.triangles());
            const double angle = kDegree * double(random() % 181);
            for (Index t = 0; t < count; ++t) {
                const TriangleSet whole = graph.connected(t), smooth = graph.smooth(t, angle);
                QVERIFY(isTriangleSet(whole, count));
                QVERIFY(isTriangleSet(smooth, count));
                QVERIFY(std::ranges::includes(whole, smooth));
                QVERIFY(std::ranges::binary_search(smooth, t));
                for (Index other : whole)
                    QCOMPARE(graph.connected(other), whole);
                for (Index other : smooth)
                    QCOMPARE(graph.smooth(other, angle), smooth);
                QVERIFY(std::ranges::includes(graph.smooth(t, angle + 0.1), smooth));
            }
        }
    }

    void growingAndShrinkingAreEachOthersMirror() {
        std::mt19937 random(9);
        for (int round = 0; round < 300; ++round) {
            const FaceGraph graph = graphOf(tangle(random, 1 + Index(random() % 60)));
            const TriangleSoup& soup = *graph.soup();
            TriangleSet set;
            for (Index t = 0; t < graph.triangles(); ++t)
                if (random() % 3 == 0) set.push_back(t);
            const TriangleSet grown = graph.grown(set), shrunk = graph.shrunk(set);
            QVERIFY(std::ranges::includes(grown, set));
            QVERIFY(std::ranges::includes(set, shrunk));
            QVERIFY(std::ranges::includes(graph.shrunk(grown), set));
            QVERIFY(std::ranges::includes(set, graph.grown(shrunk)));
            QCOMPARE(inverted(soup, graph.grown(inverted(soup, set))), shrunk);
            QCOMPARE(inverted(soup, inverted(soup, set)), set);
            QCOMPARE_LE(graph.outline(all(graph.triangles())).size(), graph.outline(set).size() + 180);
            for (Index surface = 0; surface < 4; ++surface) {
                const TriangleSet of = trianglesOf(soup, surface), rest = inverted(soup, set, surface);
                TriangleSet inside;
                std::ranges::set_intersection(of, set, std::back_inserter(inside));
                QCOMPARE(rest.size() + inside.size(), of.size());
                QVERIFY(std::ranges::includes(of, rest));
            }
        }
    }

    /// A million triangles around one vertex, over one edge, and on each other: linear, or this never ends.
    void hostileSoupsTakeNoLonger() {
        const Index n = 1'000'000;
        TriangleSoup fan, book, pile;
        fan.positions = {{0, 0, 0}};
        book.positions = {{0, 0, 0}, {0, 0, 1}};
        pile.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        for (Index i = 0; i < n; ++i) {
            const double turn = 2 * M_PI * i / n;
            fan.positions.emplace_back(std::cos(turn), std::sin(turn), 0);
            book.positions.emplace_back(std::cos(turn), std::sin(turn), 0);
            fan.triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
            book.triangles.push_back({0, 1, 2 + i});
            pile.triangles.push_back({i % 3, (i + 1) % 3, (i + 2) % 3});
        }
        for (TriangleSoup* soup : {&fan, &book, &pile}) {
            soup->surfaceOf.assign(n, 0);
            const FaceGraph graph = graphOf(std::move(*soup));
            QCOMPARE(graph.connected(5).size(), std::size_t(n));
            QCOMPARE(graph.smooth(5, 0.1).size(), soup == &fan ? std::size_t(n) : std::size_t(1));
            QCOMPARE(graph.grown({5}).size(), soup == &fan ? std::size_t(3) : std::size_t(n));
            QCOMPARE(graph.outline({5}).size(), std::size_t(3));
            QVERIFY(graph.shrunk({5}).empty());
        }
    }

    void nothingAndCancellingAreNoTrouble() {
        const FaceGraph none = graphOf({});
        QVERIFY(none.grown({}).empty());
        QVERIFY(none.shrunk({}).empty());
        QVERIFY(none.outline({}).empty());
        const std::atomic<bool> cancelled = true;
        QVERIFY(!FaceGraph::build(std::make_shared<const TriangleSoup>(cube()), Progress{{}, &cancelled}));
    }
};

TACTUM_TEST(TestFaceGraph)

} // namespace test_face_graph

#include "test_face_graph.moc"
