#include "core/geometry/orientation.h"

#include <algorithm>
#include <cmath>

namespace tactum {
namespace {

/// What hangs together over edges of two triangles.
struct Patch {
    std::size_t first = 0, last = 0; ///< in the order of visit
    bool closed = true;              ///< no border, no edge of more than two
    bool orientable = true;
    bool agreed = true; ///< no edge was flipped
    double area = 0;    ///< m^2, twice it
    double turned = 0;  ///< of it, what is to be turned over
    double volume = 0;  ///< six times it, as it will be
    Bounds box;
    bool turnsWhole = false;
};

class Orienting {
public:
    Orienting(const FaceGraph& graph, const Progress& progress)
        : graph_(graph), soup_(*graph.soup()), meter_(progress, graph.triangles()),
          state_(graph.triangles(), kUnseen) {
        order_.reserve(graph.triangles());
    }

    Result<Orientation> run() {
        for (Index t = 0; t < state_.size(); ++t)
            if (state_[t] == kUnseen && !visit(t)) return cancelledError();
        for (Patch& patch : patches_)
            decide(patch);
        return result();
    }

private:
    static constexpr char kUnseen = -1, kStays = 0, kTurns = 1;

    Vec3 corner(Index t, std::size_t i) const { return soup_.positions[soup_.triangles[t][i]]; }

    bool visit(Index seed) {
        Patch patch;
        patch.first = order_.size();
        state_[seed] = kStays;
        order_.push_back(seed);
        for (std::size_t i = patch.first; i < order_.size(); ++i) {
            if (!meter_.goesOn(i)) return false;
            for (int side = 0; side < 3; ++side)
                cross(patch, order_[i], side);
        }
        patch.last = order_.size();
        for (std::size_t i = patch.first; i < patch.last; ++i)
            measure(patch, order_[i]);
        patches_.push_back(patch);
        return true;
    }

    void cross(Patch& patch, Index t, int side) {
        const FaceGraph::Edge edge = graph_.edgeOf(t, side);
        if (edge != FaceGraph::Edge::Joint && edge != FaceGraph::Edge::Flipped) {
            patch.closed = false;
            return;
        }
        const bool flipped = edge == FaceGraph::Edge::Flipped;
        const Index next = graph_.neighbour(t, side);
        const char state = char(state_[t] ^ char(flipped));
        patch.agreed &= !flipped;
        if (state_[next] == kUnseen) {
            state_[next] = state;
            order_.push_back(next);
        }
        patch.orientable &= state_[next] == state;
    }

    void measure(Patch& patch, Index t) {
        const Vec3 a = corner(t, 0), b = corner(t, 1), c = corner(t, 2);
        const Vec3 origin = corner(order_[patch.first], 0); // near by, for the sake of rounding
        const double area = (b - a).cross(c - a).norm();
        const double volume = (a - origin).dot((b - origin).cross(c - origin));
        patch.area += area;
        if (state_[t] == kTurns) patch.turned += area;
        patch.volume += state_[t] == kTurns ? -volume : volume;
        for (const Vec3& p : {a, b, c})
            patch.box.add(p);
    }

    void decide(Patch& patch) {
        if (!patch.orientable) {
            for (std::size_t i = patch.first; i < patch.last; ++i)
                state_[order_[i]] = kStays;
            return;
        }
        if (patch.turned > 0.5 * patch.area) turnTheOthers(patch);
        const double least = 1e-9 * std::pow(patch.area, 1.5);
        if (patch.closed && patch.volume < -least && isOutermost(patch)) {
            turnTheOthers(patch);
            patch.turnsWhole = patch.agreed;
        }
    }

    void turnTheOthers(Patch& patch) {
        for (std::size_t i = patch.first; i < patch.last; ++i)
            state_[order_[i]] = char(!state_[order_[i]]);
        patch.turned = patch.area - patch.turned;
        patch.volume = -patch.volume;
    }

    bool isOutermost(const Patch& patch) {
        const Index t = order_[patch.first];
        const Vec3 p = (corner(t, 0) + corner(t, 1) + corner(t, 2)) / 3;
        for (const Patch& other : patches_) {
            const bool holds = (other.box.low.array() <= patch.box.low.array()).all() &&
                               (other.box.high.array() >= patch.box.high.array()).all();
            if (&other == &patch || !other.closed || !other.orientable || !holds) continue;
            const std::size_t work = other.last - other.first;
            if (work > budget_) return false;
            budget_ -= work;
            if (encloses(other, p)) return false;
        }
        return true;
    }

    /// By its solid angle (A. Van Oosterom and J. Strackee, "The Solid Angle of a Plane Triangle", 1983).
    bool encloses(const Patch& patch, const Vec3& p) const {
        double halves = 0;
        for (std::size_t i = patch.first; i < patch.last; ++i) {
            const Index t = order_[i];
            const Vec3 a = corner(t, 0) - p, b = corner(t, 1) - p, c = corner(t, 2) - p;
            const double la = a.norm(), lb = b.norm(), lc = c.norm();
            const double half =
                std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
            halves += state_[t] == kTurns ? -half : half;
        }
        return std::abs(halves) > M_PI;
    }

    Orientation result() const {
        Orientation result;
        for (Index t = 0; t < state_.size(); ++t)
            if (state_[t] == kTurns) result.turned.push_back(t);
        for (const Patch& patch : patches_) {
            if (!patch.turnsWhole) continue;
            ++result.insideOutPatches;
            result.insideOut.insert(result.insideOut.end(), order_.begin() + std::ptrdiff_t(patch.first),
                                    order_.begin() + std::ptrdiff_t(patch.last));
        }
        std::ranges::sort(result.insideOut);
        return result;
    }

    const FaceGraph& graph_;
    const TriangleSoup& soup_;
    ProgressMeter meter_;
    std::vector<char> state_;
    std::vector<Index> order_;
    std::vector<Patch> patches_;
    std::size_t budget_ = 200'000'000;
};

} // namespace

Result<Orientation> orientationOf(const FaceGraph& graph, const Progress& progress) {
    return Orienting(graph, progress).run();
}

} // namespace tactum
