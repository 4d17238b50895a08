// Closing holes: their rims, what may be a lid, and the lid.
#include <algorithm>
#include <limits>
#include <optional>
#include <unordered_set>

#include "core/geometry/face_graph.h"
#include "core/geometry/filing.h"
#include "core/geometry/polygon.h"
#include "core/geometry/repair.h"
#include "core/geometry/repair_parts.h"
#include "core/geometry/weld.h"

namespace tactum {
namespace {

constexpr Index kNobody = ~Index{0};
/// Lids that are not flat cost the third power of their edges.
constexpr std::size_t kMaxCurved = 120;
/// Of the size of a rim: nearer to one plane than that is flat.
constexpr double kFlat = 1e-6;

/// A corner of a rim, where the edge of a triangle begins that nobody else has.
struct RimCorner {
    Index place; ///< welded vertex
    Index triangle;
    Index corner; ///< 0 to 2, of the triangle
};
using Rim = std::vector<RimCorner>; ///< in the direction of the hole: against that of its triangles

using Lid = std::vector<std::array<Index, 3>>; ///< numbers of corners of the rim

class Filling {
public:
    Filling(const SharedSoup& soup, const HoleLimits& limits, const Progress& progress)
        : soup_(*soup), limits_(limits), progress_(progress),
          weld_(weldMap(soup->positions, Progress{{}, progress.cancelled})) {}

    /// Nothing when cancelled.
    std::optional<std::size_t> run(const FaceGraph& graph, TriangleSoup& result) {
        findRims(graph);
        if (rims_.empty()) return 0;
        measureParts(graph);
        noteEdges();
        // A lid makes its region larger, and so another lid a smaller part of it: until nothing changes.
        std::size_t closed = 0;
        for (std::size_t before = rims_.size() + 1; before != rims_.size();) {
            before = rims_.size();
            std::erase_if(rims_, [&](const Rim& rim) {
                return !progress_.isCancelled() && close(graph, rim, result) && ++closed;
            });
        }
        if (progress_.isCancelled()) return std::nullopt;
        return closed;
    }

private:
    struct Start {
        RimCorner corner;
        Index next = kNobody; ///< welded vertex where its edge ends
        int out = 0, in = 0;  ///< how many edges of borders begin and end here
    };

    Index placeOf(Index t, std::size_t corner) const { return weld_[soup_.triangles[t][corner]]; }
    const Vec3& at(const RimCorner& c) const { return soup_.positions[c.place]; }

    void findRims(const FaceGraph& graph) {
        std::vector<Start> starts(weld_.size());
        for (Index t = 0; t < graph.triangles(); ++t)
            for (int side = 0; side < 3; ++side) {
                if (graph.edgeOf(t, side) != FaceGraph::Edge::Border) continue;
                const auto i = std::size_t(side);
                const Index from = placeOf(t, i), to = placeOf(t, (i + 1) % 3);
                ++starts[to].in;
                ++starts[from].out;
                starts[from].next = to;
                starts[from].corner = {from, t, Index(i)};
                onRim_.resize(weld_.size());
                onRim_[from] = onRim_[to] = 1;
            }
        std::vector<char> seen(weld_.size(), 0);
        for (Index v = 0; v < starts.size(); ++v)
            if (starts[v].out > 0 && !seen[v]) follow(starts, seen, v);
    }

    void follow(const std::vector<Start>& starts, std::vector<char>& seen, Index first) {
        Rim rim;
        Index v = first;
        bool simple = true;
        for (; v != kNobody && !seen[v]; v = starts[v].next) {
            seen[v] = 1;
            simple &= starts[v].out == 1 && starts[v].in == 1;
            rim.push_back(starts[v].corner);
        }
        if (!simple || v != first || rim.size() < 3 || rim.size() > limits_.edges) return;
        std::ranges::reverse(rim);
        rims_.push_back(std::move(rim));
    }

    void measureParts(const FaceGraph& graph) {
        areas_.assign(graph.triangles(), 0);
        for (Index t = 0; t < graph.triangles(); ++t) {
            const Corners& c = soup_.triangles[t];
            areas_[graph.partOf(t)] +=
                areaOf(soup_.positions[c[0]], soup_.positions[c[1]], soup_.positions[c[2]]);
        }
    }

    static double areaOf(const Vec3& a, const Vec3& b, const Vec3& c) {
        return 0.5 * (b - a).cross(c - a).norm();
    }

    static std::uint64_t key(Index a, Index b) {
        return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
    }

    /// Every edge that a lid could meet inside.
    void noteEdges() {
        for (Index t = 0; t < soup_.triangles.size(); ++t)
            for (std::size_t i = 0; i < 3; ++i) {
                const Index a = placeOf(t, i), b = placeOf(t, (i + 1) % 3);
                if (a != b && onRim_[a] && onRim_[b]) edges_.insert(key(a, b));
            }
    }

    /// Whether the line between two corners of a rim is the rim's, or nobody's yet.
    bool isFree(const Rim& rim, std::size_t i, std::size_t j) const {
        const std::size_t apart = i < j ? j - i : i - j;
        return apart == 1 || apart + 1 == rim.size() || !edges_.contains(key(rim[i].place, rim[j].place));
    }
    bool isFree(const Rim& rim, const Lid& lid) const {
        return std::ranges::all_of(lid, [&](const auto& t) {
            return isFree(rim, t[0], t[1]) && isFree(rim, t[1], t[2]) && isFree(rim, t[2], t[0]);
        });
    }

    static bool isFlat(const std::vector<Vec3>& outline) {
        Bounds box;
        for (const Vec3& p : outline)
            box.add(p);
        const Vec3 normal = newellNormal(outline).stableNormalized();
        return std::ranges::all_of(outline, [&](const Vec3& p) {
            return std::abs(normal.dot(p - outline[0])) <= kFlat * box.diagonal();
        });
    }

    std::optional<Lid> lidOf(const Rim& rim) {
        std::vector<Vec3> outline;
        for (const RimCorner& c : rim)
            outline.push_back(at(c));
        if (isFlat(outline) || rim.size() > kMaxCurved) {
            Lid lid = cutter_.cut(outline);
            if (lid.size() == rim.size() - 2 && !cutter_.gaveUp() && isFree(rim, lid)) return lid;
        }
        if (rim.size() > kMaxCurved) return std::nullopt;
        return smallestLid(rim, outline);
    }

    /// The triangulation of the least area, by the best one of every stretch of the rim.
    std::optional<Lid> smallestLid(const Rim& rim, const std::vector<Vec3>& outline) const {
        const std::size_t n = rim.size();
        std::vector<double> least(n * n, 0);
        std::vector<Index> apex(n * n, 0);
        for (std::size_t span = 2; span < n; ++span)
            for (std::size_t i = 0, j = span; j < n; ++i, ++j) {
                double& best = least[i * n + j];
                best = std::numeric_limits<double>::infinity();
                if (!isFree(rim, i, j)) continue;
                for (std::size_t k = i + 1; k < j; ++k) {
                    const double area =
                        least[i * n + k] + least[k * n + j] + areaOf(outline[i], outline[k], outline[j]);
                    if (area >= best) continue;
                    best = area;
                    apex[i * n + j] = Index(k);
                }
            }
        if (!(least[n - 1] < std::numeric_limits<double>::infinity())) return std::nullopt;
        Lid lid;
        std::vector<std::array<std::size_t, 2>> stretches{{0, n - 1}};
        while (!stretches.empty()) {
            const auto [i, j] = stretches.back();
            stretches.pop_back();
            if (j - i < 2) continue;
            const Index k = apex[i * n + j];
            lid.push_back({Index(i), k, Index(j)});
            stretches.push_back({i, k});
            stretches.push_back({k, j});
        }
        return lid;
    }

    bool close(const FaceGraph& graph, const Rim& rim, TriangleSoup& result) {
        const std::optional<Lid> lid = lidOf(rim);
        if (!lid) return false;
        double area = 0;
        for (const auto& t : *lid)
            area += areaOf(at(rim[t[0]]), at(rim[t[1]]), at(rim[t[2]]));
        double& region = areas_[graph.partOf(rim[0].triangle)];
        if (area > limits_.area * (region + area)) return false;
        region += area;
        for (const auto& t : *lid)
            addTriangle(rim, t, result);
        return true;
    }

    void addTriangle(const Rim& rim, const std::array<Index, 3>& corners, TriangleSoup& result) {
        Corners vertices;
        for (std::size_t i = 0; i < 3; ++i) {
            const RimCorner& c = rim[corners[i]];
            vertices[i] = soup_.triangles[c.triangle][c.corner];
            edges_.insert(key(c.place, rim[corners[(i + 1) % 3]].place));
            if (!soup_.cornerUvs.empty())
                result.cornerUvs.push_back(soup_.cornerUvs[3 * std::size_t(c.triangle) + c.corner]);
        }
        result.triangles.push_back(vertices);
        result.surfaceOf.push_back(soup_.surfaceOf[rim[corners[0]].triangle]);
        if (soup_.cornerNormals.empty()) return;
        const auto& p = soup_.positions;
        const Vec3 normal = (p[vertices[1]] - p[vertices[0]]).cross(p[vertices[2]] - p[vertices[0]]);
        const Vec3 unit = normal == Vec3::Zero() ? Vec3::UnitZ() : Vec3(normal.stableNormalized());
        result.cornerNormals.insert(result.cornerNormals.end(), 3, unit.cast<float>());
    }

    const TriangleSoup& soup_;
    const HoleLimits& limits_;
    const Progress& progress_;
    std::vector<Index> weld_;
    std::vector<char> onRim_;
    std::vector<Rim> rims_;
    std::vector<double> areas_; ///< of each connected region, at its lowest triangle
    std::unordered_set<std::uint64_t> edges_;
    PolygonCutter cutter_;
};

} // namespace

Result<Repaired> fillHoles(const SharedSoup& soup, const HoleLimits& limits, const Progress& progress) {
    const Result<FaceGraph> graph = FaceGraph::build(soup, partOf(progress, 0, 0.5));
    if (!graph) return cancelledError();
    TriangleSoup result = *soup;
    const Progress rest = partOf(progress, 0.5, 1);
    const std::optional<std::size_t> closed = Filling(soup, limits, rest).run(*graph, result);
    if (!closed || progress.isCancelled()) return cancelledError();
    std::string done = sentence(*closed, "hole", "holes", "closed");
    if (*closed == 0) return Repaired{soup, 0, std::move(done)};
    return Repaired{std::make_shared<const TriangleSoup>(std::move(result)), *closed, std::move(done)};
}

} // namespace tactum
