// Sweeping: spheres and planes prune in single precision with a margin, closed forms decide in double.

#include <algorithm>

#include "core/collision/sphere_tree.h"

namespace tactum {

namespace {

using Lane = SphereTree::Lane;

// Depth-first with a fixed stack: the builder bounds the depth to 64 levels and 32 halvings, and each level
// leaves at most seven siblings waiting.
constexpr int kStackSize = (64 + 32) * (SphereTree::kWidth - 1) + SphereTree::kWidth;

// The path in single precision. `slack` bounds every rounding of the pruning tests, so that they only ever
// let too much through.
struct PruningPath {
    Eigen::Vector3f from, motion;
    float inverseLength2, radius, slack;

    PruningPath(const SpherePath& path, float reach)
        : from(path.from.cast<float>()), motion(path.motion.cast<float>()), radius(float(path.radius)) {
        const float length2 = motion.squaredNorm();
        inverseLength2 = length2 > 1e-30f ? 1 / length2 : 0;
        const float size = reach + from.cwiseAbs().maxCoeff() + motion.cwiseAbs().maxCoeff() + radius;
        slack = 4e-6f * size;
    }

    // Which of the spheres the moving sphere comes near before `until`.
    auto near(const Lane& x, const Lane& y, const Lane& z, const Lane& r, float until) const {
        const Lane mx = x - from.x(), my = y - from.y(), mz = z - from.z();
        const Lane along =
            ((mx * motion.x() + my * motion.y() + mz * motion.z()) * inverseLength2).max(0.0f).min(until);
        const Lane dx = mx - along * motion.x(), dy = my - along * motion.y(), dz = mz - along * motion.z();
        const Lane reach = r + (radius + slack);
        const Lane distance2 = dx * dx + dy * dy + dz * dz;
        return ((distance2 <= reach * reach) && (reach > 0.0f)).eval();
    }

    // Which of the planes the moving sphere comes within its radius of before `until`.
    auto crosses(const SphereTree::Leaf& leaf, float until) const {
        const Lane start = leaf.nx * (from.x() - leaf.x) + leaf.ny * (from.y() - leaf.y) +
                           leaf.nz * (from.z() - leaf.z) - leaf.offset;
        const Lane end = start + (leaf.nx * motion.x() + leaf.ny * motion.y() + leaf.nz * motion.z()) * until;
        const float limit = radius + slack;
        return ((start.min(end) <= limit) && (start.max(end) >= -limit)).eval();
    }
};

} // namespace

SweepHit SphereTree::sweep(const TriangleSoup& soup, const SpherePath& path,
                           std::span<const Index> excluded) const noexcept {
    SweepHit hit;
    if (nodes_.empty()) return hit;
    const PruningPath pruning(path, reach_);
    float until = 1;
    auto testLeaf = [&](const Leaf& leaf) {
        const auto candidate =
            (pruning.near(leaf.x, leaf.y, leaf.z, leaf.radius, until) && pruning.crosses(leaf, until)).eval();
        for (int i = 0; i < kWidth; ++i) {
            if (!candidate[i]) continue;
            const Index index = leaf.triangle[i];
            if (std::find(excluded.begin(), excluded.end(), index) != excluded.end()) continue;
            const auto& corner = soup.triangles[index];
            const Triangle triangle{soup.positions[corner[0]], soup.positions[corner[1]],
                                    soup.positions[corner[2]]};
            const double t = sweepSphere(triangle, path.from, path.motion, path.radius);
            if (t < hit.t) {
                hit = {t, index};
                until = float(t);
            }
        }
    };
    std::int32_t stack[kStackSize];
    int size = 0;
    stack[size++] = 0;
    while (size > 0) {
        const std::int32_t top = stack[--size];
        if (top < 0) {
            testLeaf(leaves_[std::size_t(~top)]);
            continue;
        }
        const Node& node = nodes_[std::size_t(top)];
        const auto near = pruning.near(node.x, node.y, node.z, node.radius, until);
        for (int i = 0; i < kWidth; ++i)
            if (near[i]) stack[size++] = node.child[i];
    }
    return hit;
}

} // namespace tactum
