// One descent for both hierarchies: the same order, the same leaves, the same exact tests; only the bound of
// a child differs. It can count what it does.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "tests/benchmarks/box_tree.h"

namespace tactum::bench {
namespace {

// The same kernel that the sphere tree's queries are compiled from.
#if defined(__AVX__)
#define TACTUM_AVX
#endif
#include "core/collision/kernel/lanes.inc"

#include "core/collision/kernel/pruning_path.inc"

/// The path of a sweep against boxes, bounded as PruningPath does it against coins.
class BoxPath {
public:
    explicit BoxPath(const SpherePath& path) {
        const Eigen::Vector3f from = path.from.cast<float>(), motion = path.motion.cast<float>();
        const float length = motion.norm();
        slack_ = 4e-7f * from.cwiseAbs().maxCoeff() + 1e-6f * (float(path.radius) + length);
        radius_ = float(path.radius) + slack_;
        isLong_ = length > radius_;
        from_ = {all(from.x()), all(from.y()), all(from.z())};
        motion_ = {all(motion.x()), all(motion.y()), all(motion.z())};
        inverse_ = {all(inverted(motion.x())), all(inverted(motion.y())), all(inverted(motion.z()))};
    }

    // The distance to a box is convex along the path, so it stays above its tangent at the start.
    Lanes contactTime(const BoxTree::Node& node, float until) const {
        const Lanes zero = all(0);
        const Lanes3 low = {load(node.lx), load(node.ly), load(node.lz)};
        const Lanes3 high = {load(node.hx), load(node.hy), load(node.hz)};
        const Lanes3 to = {toward(low.x, high.x, from_.x), toward(low.y, high.y, from_.y),
                           toward(low.z, high.z, from_.z)};
        const Lanes distance = sqrt(max(dot(to, to), all(1e-30f)));
        const Lanes gap = distance - all(radius_);
        const Lanes approach = all(slack_) + dot(to, motion_) / distance;
        const Lanes time =
            choose(zero < approach, max(gap, zero) / approach, choose(gap <= zero, zero, all(kNever)));
        if (!isLong_) return time;
        // Far from its start a path leaves the tangent behind: the box, widened by the sphere, cuts a piece
        // out of it.
        Lanes enter = zero, leave = all(until);
        cut(low.x, high.x, from_.x, inverse_.x, enter, leave);
        cut(low.y, high.y, from_.y, inverse_.y, enter, leave);
        cut(low.z, high.z, from_.z, inverse_.z, enter, leave);
        return choose(enter <= leave, max(time, enter), all(kNever));
    }

private:
    static float inverted(float x) { return 1 / (std::abs(x) < 1e-20f ? 1e-20f : x); }
    static Lanes toward(Lanes low, Lanes high, Lanes p) {
        return max(low - p, all(0)) + min(high - p, all(0));
    }
    void cut(Lanes low, Lanes high, Lanes p, Lanes inverse, Lanes& enter, Lanes& leave) const {
        const Lanes r = all(radius_);
        const Lanes a = (low - r - p) * inverse, b = (high + r - p) * inverse;
        // Rounded outward, for the bound may not be late.
        enter = max(enter, min(a, b) * all(1 - 1e-6f));
        leave = min(leave, max(a, b) * all(1 + 1e-6f));
    }

    Lanes3 from_, motion_, inverse_;
    float slack_ = 0, radius_ = 0;
    bool isLong_ = false;
};

/// What sweeps did, in sum.
struct Work {
    std::size_t nodes = 0, leaves = 0, exact = 0;
};

/// A sweep through nodes whose children `Bound` can time; `kCounted` also counts into `work`.
template <class Node, class Bound, bool kCounted> class Descent {
public:
    Descent(std::span<const Node> nodes, std::span<const SphereTree::Leaf> leaves, const TriangleSoup& soup,
            const SpherePath& path, std::span<const Index> excluded, Work& work)
        : nodes_(nodes), leaves_(leaves), soup_(soup), path_(path), excluded_(excluded), work_(work),
          bound_(path), pruning_(path) {}

    /// From `start`: the root, or what was gathered.
    SweepHit run(Index hint, std::span<const Node> start) {
        if (hint < leaves_.size()) test(hint);
        for (const Node& node : start)
            open(node);
        while (size_ > 0) {
            const Waiting top = waiting_[--size_];
            if (top.time > until_) continue;
            if (top.child >= 0)
                open(nodes_[std::size_t(top.child)]);
            else if (Index(~top.child) != hint)
                test(Index(~top.child));
        }
        return hit_;
    }

private:
    struct Waiting {
        float time;
        std::int32_t child;
    };

    void open(const Node& node) {
        if constexpr (kCounted) ++work_.nodes;
        const Lanes times = bound_.contactTime(node, until_);
        unsigned reached = bits(times <= all(until_));
        if (reached == 0) return;
        LaneArray time;
        store(time, times);
        const int first = size_;
        int soonest = size_;
        for (; reached != 0; reached &= reached - 1) {
            const int lane = std::countr_zero(reached);
            waiting_[size_] = {time[lane], node.child[lane]};
            if (time[lane] < waiting_[soonest].time) soonest = size_;
            ++size_;
        }
        if (size_ > first) std::swap(waiting_[soonest], waiting_[size_ - 1]);
    }

    void test(Index leafIndex) {
        if constexpr (kCounted) ++work_.leaves;
        const SphereTree::Leaf& leaf = leaves_[leafIndex];
        Lanes gaps;
        Seen seen;
        const Lanes times = pruning_.contactTime(leaf, until_, 0, gaps, seen);
        unsigned reached = bits(times <= all(until_));
        if (reached == 0) return;
        LaneArray time;
        store(time, times);
        for (; reached != 0; reached &= reached - 1) {
            const int lane = std::countr_zero(reached);
            if (time[lane] <= until_) test(leaf.triangle[lane], leafIndex);
        }
    }

    void test(Index index, Index leafIndex) {
        if (std::find(excluded_.begin(), excluded_.end(), index) != excluded_.end()) return;
        if constexpr (kCounted) ++work_.exact;
        const auto& corner = soup_.triangles[index];
        const Triangle triangle{soup_.positions[corner[0]], soup_.positions[corner[1]],
                                soup_.positions[corner[2]]};
        const double t = sweepSphere(triangle, path_.from, path_.motion, path_.radius, hit_.t);
        if (!(t < hit_.t)) return;
        hit_.t = t;
        hit_.triangle = index;
        hit_.leaf = leafIndex;
        until_ = std::nextafter(float(t), kNever);
    }

    std::span<const Node> nodes_;
    std::span<const SphereTree::Leaf> leaves_;
    const TriangleSoup& soup_;
    const SpherePath& path_;
    std::span<const Index> excluded_;
    Work& work_;
    const Bound bound_;
    const PruningPath pruning_;
    SweepHit hit_{};
    float until_ = 1;
    int size_ = 0;
    Waiting waiting_[1024];
};

} // namespace
} // namespace tactum::bench
