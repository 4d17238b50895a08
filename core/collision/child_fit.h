// Fits the children of the hierarchy's nodes to what they hold.
#pragma once

#include <array>
#include <vector>

#include "core/collision/leaf_cover.h"
#include "core/collision/sphere_tree.h"

namespace tactum {

/// Leaf spheres [begin, end).
struct LeafRange {
    std::uint32_t begin = 0, end = 0;
};

/// Which leaf spheres lie below each child of each node.
using ChildRanges = std::vector<std::array<LeafRange, SphereTree::kWidth>>;

/// Puts a sphere, as seen from the nodes' origin, around child i. Thread: any.
inline void place(SphereTree::Node& node, int i, const Eigen::Vector3f& centre, float radius) {
    node.x[i] = centre.x();
    node.y[i] = centre.y();
    node.z[i] = centre.z();
    node.radius[i] = radius;
}

/// Makes the spheres of children that hold few primitives as small as their corners allow, where that is
/// smaller, and gives those whose primitives lie flat a pair of planes. Positions in nodes are as seen from
/// `origin`. Thread: any but real time; uses all cores. O(n).
void fitChildren(std::vector<SphereTree::Node>& nodes, const ChildRanges& ranges, const TriangleSoup& soup,
                 const std::vector<LeafSphere>& leafSpheres, const Vec3& origin);

} // namespace tactum
