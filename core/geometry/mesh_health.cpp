#include "core/geometry/mesh_health.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/geometry/filing.h"
#include "core/geometry/sliver.h"
#include "core/geometry/weld.h"

namespace tactum {
namespace {

class Examination {
public:
    Examination(const TriangleSoup& soup, const Progress& progress)
        : soup_(soup), progress_(progress),
          meter_(progress, 4 * soup.triangles.size() + 2 * soup.positions.size()),
          weld_(weldMap(soup.positions, Progress{{}, progress.cancelled})) {}

    Result<MeshHealth> run() {
        health_.hasNormals = !soup_.cornerNormals.empty();
        health_.hasUvs = !soup_.cornerUvs.empty();
        const bool whole = countKinds() && countParts() && countEdges() && countDuplicates();
        if (!whole || progress_.isCancelled()) return cancelledError();
        return health_;
    }

private:
    Corners welded(const Corners& t) const { return {weld_[t[0]], weld_[t[1]], weld_[t[2]]}; }

    bool goesOn() { return meter_.goesOn(++done_); }

    /// Calls f with the welded corners of every triangle; false when cancelled.
    template <class F> bool eachTriangle(F f) {
        for (const Corners& t : soup_.triangles) {
            if (!goesOn()) return false;
            f(welded(t));
        }
        return true;
    }

    bool countKinds() {
        const SliverRule isSliver(soup_);
        return eachTriangle([&](const Corners& t) {
            const Kind kind = kindOf(t);
            ++(kind == Kind::Triangle  ? health_.triangles
               : kind == Kind::Segment ? health_.segments
                                       : health_.points);
            if (kind != Kind::Triangle) return;
            health_.slivers += isSliver(t);
        });
    }

    bool countParts() {
        UnionFind parts(weld_.size());
        std::vector<char> used(weld_.size(), 0);
        std::size_t joins = 0, places = 0;
        const auto use = [&](Index v) { places += !std::exchange(used[v], 1); };
        const bool whole = eachTriangle([&](const Corners& t) {
            for (Index v : t)
                use(v);
            joins += parts.join(t[0], t[1]);
            joins += parts.join(t[1], t[2]);
        });
        health_.components = places - joins;
        countUnreferenced();
        return whole;
    }

    void countUnreferenced() {
        std::vector<char> used(soup_.positions.size(), 0);
        for (const Corners& t : soup_.triangles)
            for (Index v : t)
                used[v] = 1;
        health_.unreferencedVertices = std::size_t(std::count(used.begin(), used.end(), 0));
    }

    /// Files each edge under its lower vertex as (upper vertex, direction), so that equal edges meet.
    bool countEdges() {
        using Edge = std::uint64_t;
        FiledByVertex<Edge> edges(weld_.size());
        const auto eachEdge = [](const Corners& t, auto f) {
            if (kindOf(t) != Kind::Triangle) return;
            for (int i = 0; i < 3; ++i)
                f(t[i], t[(i + 1) % 3]);
        };
        for (const Corners& t : soup_.triangles)
            eachEdge(welded(t), [&](Index a, Index b) { edges.count(std::min(a, b)); });
        edges.allocate();
        const bool whole = eachTriangle([&](const Corners& t) {
            eachEdge(t, [&](Index a, Index b) {
                edges.place(std::min(a, b), Edge(std::max(a, b)) << 1 | (a < b));
            });
        });
        UnionFind rims(weld_.size());
        for (Index v = 0; whole && v < edges.vertices() && goesOn(); ++v)
            judgeEdges(v, edges.begin(v), edges.end(v), rims);
        return whole;
    }

    void judgeEdges(Index vertex, std::uint64_t* first, std::uint64_t* last, UnionFind& rims) {
        std::sort(first, last);
        for (auto* edge = first; edge != last;) {
            auto* after = edge;
            std::size_t forward = 0;
            for (; after != last && *after >> 1 == *edge >> 1; ++after)
                forward += *after & 1;
            const std::size_t uses = std::size_t(after - edge);
            health_.nonManifoldEdges += uses > 2;
            health_.flippedEdges += uses == 2 && forward != 1;
            if (uses == 1) countRim(vertex, Index(*edge >> 1), rims);
            edge = after;
        }
    }

    void countRim(Index a, Index b, UnionFind& rims) {
        ++health_.boundaryEdges;
        if (rim_.empty()) rim_.assign(weld_.size(), 0);
        health_.holes += !std::exchange(rim_[a], 1);
        health_.holes += !std::exchange(rim_[b], 1);
        health_.holes -= rims.join(a, b);
    }

    bool countDuplicates() {
        using Others = std::pair<Index, Index>; // of a triangle's corners, sorted
        FiledByVertex<Others> faces(weld_.size());
        for (const Corners& t : soup_.triangles)
            faces.count(std::ranges::min(welded(t)));
        faces.allocate();
        const bool whole = eachTriangle([&](Corners t) {
            std::sort(t.begin(), t.end());
            faces.place(t[0], {t[1], t[2]});
        });
        for (Index v = 0; whole && v < faces.vertices() && goesOn(); ++v) {
            std::sort(faces.begin(v), faces.end(v));
            const auto* distinct = std::unique(faces.begin(v), faces.end(v));
            health_.duplicateFaces += std::size_t(faces.end(v) - distinct);
        }
        return whole;
    }

    const TriangleSoup& soup_;
    const Progress& progress_;
    ProgressMeter meter_;
    std::size_t done_ = 0;
    std::vector<Index> weld_;
    std::vector<char> rim_; ///< vertices of boundary edges
    MeshHealth health_;
};

/// Which corners (0 to 2) a flat triangle's segment or point has; nothing for one that has an area.
std::optional<std::array<int, 3>> collapsedCorners(const TriangleSoup& soup, const Corners& t) {
    constexpr double kFlat = 1e-12;
    const Vec3 &a = soup.positions[t[0]], &b = soup.positions[t[1]], &c = soup.positions[t[2]];
    const double sides[] = {(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()};
    const auto longest = int(std::max_element(sides, sides + 3) - sides);
    if ((b - a).cross(c - a).norm() > kFlat * sides[longest]) return std::nullopt;
    if (sides[longest] == 0) return std::array{0, 0, 0};
    return std::array{longest, (longest + 1) % 3, (longest + 1) % 3};
}

/// Makes the corners of a triangle copies of some of them, with all they carry.
void takeCorners(TriangleSoup& soup, std::size_t face, const std::array<int, 3>& sources) {
    const auto take = [&](auto* first) {
        const std::array old{first[0], first[1], first[2]};
        for (int i = 0; i < 3; ++i)
            first[i] = old[std::size_t(sources[i])];
    };
    take(soup.triangles[face].data());
    if (!soup.cornerNormals.empty()) take(&soup.cornerNormals[3 * face]);
    if (!soup.cornerUvs.empty()) take(&soup.cornerUvs[3 * face]);
}

} // namespace

Result<MeshHealth> healthOf(const TriangleSoup& soup, const Progress& progress) {
    return Examination(soup, progress).run();
}

CollapsedTriangles collapseFlatTriangles(TriangleSoup& soup, const Progress& progress) {
    CollapsedTriangles collapsed;
    ProgressMeter meter(progress, soup.triangles.size());
    for (std::size_t f = 0; f < soup.triangles.size() && meter.goesOn(f); ++f) {
        const auto sources = collapsedCorners(soup, soup.triangles[f]);
        if (!sources) continue;
        const Corners before = soup.triangles[f];
        takeCorners(soup, f, *sources);
        if (soup.triangles[f] == before) continue;
        ++(kindOf(soup.triangles[f]) == Kind::Point ? collapsed.toPoints : collapsed.toSegments);
    }
    return collapsed;
}

} // namespace tactum
