// Sweeping: spheres and planes prune in single precision with a margin, closed forms decide in double.

#include <algorithm>
#include <bit>
#include <cmath>

#if defined(__SSE__)
#include <immintrin.h>
#endif

#include "core/collision/sphere_tree.h"

namespace tactum {

namespace {

using Lane = SphereTree::Lane;

constexpr float kFar = 1e30f;

// Depth-first with a fixed stack: the builder bounds the depth to 64 levels and 32 halvings, and each level
// leaves at most seven siblings waiting.
constexpr int kStackSize = (64 + 32) * (SphereTree::kWidth - 1) + SphereTree::kWidth;

// The path in single precision. Every pruning test is widened by a bound on its own rounding, so that it only
// ever lets too much through: `slack` for the path, kRounding of the radius for each sphere of the tree.
struct PruningPath {
    static constexpr float kRounding = 1e-6f;
    Eigen::Vector3f from, motion;
    float slack, radius;
    bool isLong = false; ///< longer than the proxy's radius
    float inverseLength2 = 0;

    explicit PruningPath(const SpherePath& path)
        : from(path.from.cast<float>()), motion(path.motion.cast<float>()) {
        // The start is rounded by half an ulp in each coordinate; differences and products lose a few more of
        // what is left after the subtraction.
        slack = 2e-7f * from.cwiseAbs().maxCoeff() + kRounding * (float(path.radius) + motion.norm());
        radius = float(path.radius) + slack;
        const float length2 = motion.squaredNorm();
        isLong = length2 > radius * radius;
        if (isLong) inverseLength2 = 1 / length2;
    }

    // A lower bound of the time at which the moving sphere touches what each child holds. The distance to a
    // coin is convex along the path, so it stays above its tangent at the start. kFar where there is no
    // contact before `until`.
    Lane contactTime(const SphereTree::Node& node, float until) const {
        const Lane mx = from.x() - node.x, my = from.y() - node.y, mz = from.z() - node.z;
        const Lane lift = node.nx * mx + node.ny * my + node.nz * mz;
        const Lane height = lift - node.offset;
        const Lane above = (height.abs() - node.thickness).max(0.0f);
        const Lane across = (mx * mx + my * my + mz * mz - lift * lift).max(1e-30f).sqrt();
        const Lane beside = (across - node.radius).max(0.0f);
        const Lane distance = (above * above + beside * beside).sqrt();
        const Lane gap = distance - (node.radius.abs() * kRounding + radius);
        const Lane rise = node.nx * motion.x() + node.ny * motion.y() + node.nz * motion.z();
        const Lane along = mx * motion.x() + my * motion.y() + mz * motion.z();
        const Lane climb = (height > 0.0f).select(above * rise, -above * rise);
        const Lane approach = slack - (climb + beside / across * (along - lift * rise)) / distance;
        const Lane time = (approach > 0.0f).select(gap / approach, kFar);
        const Lane bound = (gap <= 0.0f).select(0.0f, time);
        if (!isLong) return bound;
        // Far from its start a path leaves the tangent behind: what lies beside all of it is left out here.
        const Lane foot = (-along * inverseLength2).max(0.0f).min(until);
        const Lane ex = mx + foot * motion.x(), ey = my + foot * motion.y(), ez = mz + foot * motion.z();
        const Lane reach = (node.radius * (1 + kRounding) + radius).max(0.0f);
        return (ex * ex + ey * ey + ez * ez <= reach * reach).select(bound, kFar);
    }
};

// One bit for each lane that is below the limit.
unsigned below(const Lane& value, float limit) noexcept {
#if defined(__SSE__)
    const __m128 most = _mm_set1_ps(limit);
    return unsigned(_mm_movemask_ps(_mm_cmplt_ps(_mm_loadu_ps(value.data()), most))) |
           unsigned(_mm_movemask_ps(_mm_cmplt_ps(_mm_loadu_ps(value.data() + 4), most))) << 4;
#else
    unsigned bits = 0;
    for (int i = 0; i < SphereTree::kWidth; ++i)
        bits |= unsigned(value[i] < limit) << i;
    return bits;
#endif
}

// One sweep under way: the first contact so far.
struct Sweep {
    const TriangleSoup& soup;
    const SpherePath& path;
    std::span<const Index> excluded;
    const std::vector<SphereTree::Node>& leaves;
    PruningPath pruning{path};
    SweepHit hit{};
    float until = 1;

    void testLeaf(Index leafIndex) noexcept {
        const SphereTree::Node& leaf = leaves[leafIndex];
        const Lane time = pruning.contactTime(leaf, until);
        for (unsigned bits = below(time, std::nextafter(until, kFar)); bits != 0; bits &= bits - 1) {
            const int lane = std::countr_zero(bits);
            if (time[lane] <= until) testTriangle(Index(leaf.child[lane]), leafIndex);
        }
    }

    void testTriangle(Index index, Index leafIndex) noexcept {
        if (std::find(excluded.begin(), excluded.end(), index) != excluded.end()) return;
        const auto& corner = soup.triangles[index];
        const Triangle triangle{soup.positions[corner[0]], soup.positions[corner[1]],
                                soup.positions[corner[2]]};
        const double t = sweepSphere(triangle, path.from, path.motion, path.radius, hit.t);
        if (!(t < hit.t)) return;
        hit = {t, index, leafIndex};
        until = float(t);
    }
};

} // namespace

SweepHit SphereTree::sweep(const TriangleSoup& soup, const SpherePath& path, std::span<const Index> excluded,
                           Index hint) const noexcept {
    if (nodes_.empty()) return {};
    Sweep sweep{soup, path, excluded, leaves_};
    if (hint < leaves_.size()) sweep.testLeaf(hint);
    std::int32_t stack[kStackSize];
    int size = 0;
    stack[size++] = 0;
    while (size > 0) {
        const std::int32_t top = stack[--size];
        if (top < 0) {
            if (Index(~top) != hint) sweep.testLeaf(Index(~top));
            continue;
        }
        const Node& node = nodes_[std::size_t(top)];
        const Lane time = sweep.pruning.contactTime(node, sweep.until);
        // The child that can be reached first is looked into first, so that a contact shortens the path
        // early.
        int first = size;
        float soonest = kFar;
        for (unsigned bits = below(time, std::nextafter(sweep.until, kFar)); bits != 0; bits &= bits - 1) {
            const int lane = std::countr_zero(bits);
            if (time[lane] < soonest) soonest = time[lane], first = size;
            stack[size++] = node.child[lane];
        }
        if (first < size) std::swap(stack[first], stack[size - 1]);
    }
    return sweep.hit;
}

} // namespace tactum
