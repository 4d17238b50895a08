#include "core/geometry/face_graph.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>

#include "core/geometry/filing.h"
#include "core/geometry/weld.h"

namespace tactum {
namespace {

/// Between two unit vectors: exact near 0 and near pi too.
float angleBetween(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
    return 2 * std::atan2((a - b).norm(), (a + b).norm());
}

/// The squared distance of unit vectors that are as far apart: for comparing, and without an arc tangent.
/// Where only rounding keeps them from being within the angle, they are.
float squaredChord(double angle) {
    constexpr double kRounding = 5e-7;
    const double chord = 2 * std::sin(0.5 * std::min(angle, M_PI)) + kRounding;
    return float(chord * chord);
}

bool isZero(const Eigen::Vector3f& v) {
    return v == Eigen::Vector3f::Zero();
}

Eigen::Vector3f unitNormal(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 normal = (b - a).cross(c - a);
    const double length = normal.norm();
    if (!(length > 0)) return Eigen::Vector3f::Zero();
    return (normal / length).cast<float>();
}

} // namespace

class FaceGraph::Builder {
public:
    Builder(std::shared_ptr<const TriangleSoup> soup, const Progress& progress)
        : soup_(*soup), progress_(progress), meter_(progress, 3 * soup->triangles.size()),
          weld_(weldMap(soup->positions, Progress{{}, progress.cancelled})), filed_(weld_.size()),
          parts_(soup->triangles.size()) {
        graph_.soup_ = std::move(soup);
    }

    Result<FaceGraph> run() {
        const std::size_t n = soup_.triangles.size();
        assert(n < kMany);
        graph_.ring_.resize(n);
        graph_.normals_.reserve(n);
        if (progress_.isCancelled() || !findNormals() || !fileSides() || !joinSides())
            return cancelledError();
        for (Index t = 0; t < n; ++t)
            graph_.ring_[t].part = parts_.rootOf(t);
        return std::move(graph_);
    }

private:
    /// A use filed under the lower vertex of its edge; of the end of a segment both are the same.
    struct Side {
        Index upper;
        Use use;
    };

    Corners welded(Index t) const {
        const Corners& corners = soup_.triangles[t];
        return {weld_[corners[0]], weld_[corners[1]], weld_[corners[2]]};
    }
    const Vec3& place(Index t, int corner) const {
        return soup_.positions[soup_.triangles[t][std::size_t(corner)]];
    }

    bool findNormals() {
        for (Index t = 0; t < soup_.triangles.size(); ++t) {
            if (!meter_.goesOn(t)) return false;
            graph_.normals_.push_back(unitNormal(place(t, 0), place(t, 1), place(t, 2)));
        }
        return true;
    }

    /// Calls f(lower vertex, upper vertex, use) for what a triangle, segment or point can share with others.
    template <class F> void eachSide(Index t, F f) const {
        const Corners c = welded(t);
        if (kindOf(c) == Kind::Triangle) {
            for (std::uint8_t i = 0; i < 3; ++i) {
                const Index a = c[i], b = c[(i + 1) % 3];
                f(std::min(a, b), std::max(a, b), Use{t, i, a < b});
            }
            return;
        }
        f(c[0], c[0], Use{t, 0, true});
        if (c[1] != c[0]) f(c[1], c[1], Use{t, 1, true});
        if (c[2] != c[0] && c[2] != c[1]) f(c[2], c[2], Use{t, 2, true});
    }

    bool fileSides() {
        const Index n = Index(soup_.triangles.size());
        for (Index t = 0; t < n; ++t)
            eachSide(t, [&](Index lower, Index, Use) { filed_.count(lower); });
        filed_.allocate();
        for (Index t = 0; t < n; ++t) {
            if (!meter_.goesOn(n + t)) return false;
            eachSide(t, [&](Index lower, Index upper, Use use) { filed_.place(lower, {upper, use}); });
        }
        return true;
    }

    bool joinSides() {
        const std::size_t n = soup_.triangles.size();
        std::size_t done = 0;
        for (Index v = 0; v < filed_.vertices(); ++v) {
            Side *first = filed_.begin(v), *last = filed_.end(v);
            std::sort(first, last, [](const Side& a, const Side& b) {
                return std::tie(a.upper, a.use.triangle) < std::tie(b.upper, b.use.triangle);
            });
            for (Side* after = first; first != last; first = after) {
                while (after != last && after->upper == first->upper)
                    ++after;
                join(first, after, first->upper != v);
                done += std::size_t(after - first);
            }
            if (!meter_.goesOn(2 * n + done / 3)) return false;
        }
        return true;
    }

    Index& across(const Use& use) { return graph_.ring_[use.triangle].across[use.side]; }
    float& bend(const Use& use) { return graph_.ring_[use.triangle].bend[use.side]; }

    void note(const Use& use, Edge edge) { graph_.ring_[use.triangle].edge[use.side] = edge; }

    void join(const Side* first, const Side* last, bool isEdge) {
        if (isEdge) {
            const bool flipped = last - first == 2 && first[0].use.forward == first[1].use.forward;
            const Edge edge = last - first > 2    ? Edge::Crowd
                              : last - first == 1 ? Edge::Border
                              : flipped           ? Edge::Flipped
                                                  : Edge::Joint;
            for (const Side* side = first; side != last; ++side)
                note(side->use, edge);
        }
        for (const Side* side = first + 1; side != last; ++side)
            parts_.join(first->use.triangle, side->use.triangle);
        if (last - first == 2) return joinTwo(first[0].use, first[1].use);
        if (last - first < 3) return;
        const Index group = kMany + Index(graph_.begin_.size() - 1);
        for (const Side* side = first; side != last; ++side) {
            across(side->use) = group;
            graph_.uses_.push_back(side->use);
        }
        graph_.begin_.push_back(graph_.uses_.size());
    }

    void joinTwo(const Use& a, const Use& b) {
        across(a) = b.triangle;
        across(b) = a.triangle;
        bend(a) = bend(b) = bendOf(a, b);
    }

    float bendOf(const Use& a, const Use& b) const {
        const Eigen::Vector3f &one = graph_.normals_[a.triangle], &other = graph_.normals_[b.triangle];
        if (isZero(one) || isZero(other)) return bendOfSegments(a, b);
        return angleBetween(one, a.forward == b.forward ? -other : other);
    }

    float bendOfSegments(const Use& a, const Use& b) const {
        const auto isSegment = [&](Index t) { return kindOf(welded(t)) == Kind::Segment; };
        if (!isSegment(a.triangle) || !isSegment(b.triangle)) return kCrease;
        return angleBetween(wayOut(a), -wayOut(b));
    }

    /// Along a segment, away from its end.
    Eigen::Vector3f wayOut(const Use& use) const {
        const Vec3& end = place(use.triangle, use.side);
        for (int i = 0; i < 3; ++i)
            if (const Vec3 way = place(use.triangle, i) - end; way != Vec3::Zero())
                return way.stableNormalized().cast<float>();
        return Eigen::Vector3f::Zero();
    }

    const TriangleSoup& soup_;
    const Progress& progress_;
    ProgressMeter meter_;
    std::vector<Index> weld_;
    FiledByVertex<Side> filed_;
    UnionFind parts_; ///< of triangles
    FaceGraph graph_;
};

Result<FaceGraph> FaceGraph::build(std::shared_ptr<const TriangleSoup> soup, const Progress& progress) {
    return Builder(std::move(soup), progress).run();
}

/// The seed and what goes(triangle, reach) reaches from it and from what it has reached. First in, first out,
/// so that what is around a triangle has come from memory when its turn comes.
template <class Goes> TriangleSet FaceGraph::flood(Index seed, Goes goes) const {
    TriangleMarks marks(triangles());
    std::vector<Index> waiting{seed};
    marks.add(seed);
    const auto reach = [&](Index t) {
        if (!marks.add(t)) return;
        __builtin_prefetch(&ring_[t]);
        waiting.push_back(t);
    };
    for (std::size_t i = 0; i < waiting.size(); ++i)
        goes(waiting[i], reach);
    return marks.set();
}

namespace {

/// Lets every group of uses be looked at once: from the second time on all of it has been reached.
class Once {
public:
    explicit Once(std::size_t groups) : done_(groups, false) {}
    bool operator()(std::size_t group) {
        const bool first = !done_[group];
        done_[group] = true;
        return first;
    }

private:
    std::vector<bool> done_;
};

} // namespace

TriangleSet FaceGraph::connected(Index seed) const {
    TriangleSet result;
    for (Index t = 0; t < triangles(); ++t)
        if (ring_[t].part == ring_[seed].part) result.push_back(t);
    return result;
}

bool FaceGraph::goesOn(const Use& a, const Use& b, float chord) const {
    const Eigen::Vector3f &one = normals_[a.triangle], &other = normals_[b.triangle];
    return a.forward != b.forward && (one - other).squaredNorm() <= chord && !isZero(one) && !isZero(other);
}

TriangleSet FaceGraph::smooth(Index seed, double creaseAngle) const {
    const float angle = float(creaseAngle), chord = squaredChord(creaseAngle);
    const auto overGroup = [&](Index t, Index group, auto reach) {
        const Uses uses = usesOf(group);
        if (uses.size() > kMaxAround) return;
        const auto self =
            std::find_if(uses.begin(), uses.end(), [&](const Use& u) { return u.triangle == t; });
        for (const Use& use : uses)
            if (goesOn(*self, use, chord)) reach(use.triangle);
    };
    return flood(seed, [&](Index t, auto reach) {
        const Ring& ring = ring_[t];
        for (std::size_t i = 0; i < 3; ++i) {
            const Index other = ring.across[i];
            if (other >= kMany && other != kNothing)
                overGroup(t, other, reach);
            else if (ring.bend[i] <= angle)
                reach(other);
        }
    });
}

TriangleSet FaceGraph::similar(Index seed, double angle, bool connected) const {
    const float chord = squaredChord(angle);
    const Eigen::Vector3f normal = normals_[seed];
    if (isZero(normal)) return {seed};
    TriangleSet similar;
    for (Index t = 0; t < triangles(); ++t)
        if ((normals_[t] - normal).squaredNorm() <= chord && !isZero(normals_[t])) similar.push_back(t);
    if (!connected) return similar;
    const TriangleMarks isSimilar(triangles(), similar);
    Once once(begin_.size());
    return flood(seed, [&](Index t, auto reach) {
        for (int i = 0; i < 3; ++i) {
            const Index other = ring_[t].across[std::size_t(i)];
            if (other < kMany || (other != kNothing && once(other - kMany)))
                eachAcross(t, i, [&](Index next) {
                    if (isSimilar.has(next)) reach(next);
                });
        }
    });
}

TriangleSet FaceGraph::grown(const TriangleSet& set) const {
    TriangleMarks marks(triangles(), set);
    Once once(begin_.size());
    for (Index t : set)
        for (int i = 0; i < 3; ++i) {
            const Index other = ring_[t].across[std::size_t(i)];
            if (other < kMany || (other != kNothing && once(other - kMany)))
                eachAcross(t, i, [&](Index next) { marks.add(next); });
        }
    return marks.set();
}

TriangleSet FaceGraph::shrunk(const TriangleSet& set) const {
    return inverted(*soup_, grown(inverted(*soup_, set)));
}

std::vector<std::array<Index, 2>> FaceGraph::outline(const TriangleSet& set) const {
    const TriangleMarks marks(triangles(), set);
    Once once(begin_.size());
    const auto isOutline = [&](Index other) {
        if (other == kNothing) return true;
        if (other < kMany) return !marks.has(other);
        const Uses uses = usesOf(other);
        return once(other - kMany) && !std::all_of(uses.begin(), uses.end(),
                                                   [&](const Use& use) { return marks.has(use.triangle); });
    };
    std::vector<std::array<Index, 2>> edges;
    for (Index t : set) {
        const Corners& c = soup_->triangles[t];
        const auto& p = soup_->positions;
        if (p[c[0]] == p[c[1]] || p[c[1]] == p[c[2]] || p[c[2]] == p[c[0]]) continue;
        for (std::size_t i = 0; i < 3; ++i)
            if (isOutline(ring_[t].across[i])) edges.push_back({c[i], c[(i + 1) % 3]});
    }
    return edges;
}

} // namespace tactum
