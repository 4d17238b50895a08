// The rival of the sphere tree: the same primitives under axis-aligned boxes, eight to a node. Measured here,
// used nowhere else.
#pragma once

#include <vector>

#include "core/collision/lane_array.h"
#include "core/collision/sphere_tree.h"

namespace tactum::bench {

/// Built over the same pieces as the sphere tree, divided at the same planes or by the surface area
/// heuristic.
class BoxTree {
public:
    enum class Division {
        Midpoint,   ///< of the longest axis, as the sphere tree does
        SurfaceArea ///< where the areas of the two boxes, weighted by what they hold, are least (16 bins)
    };

    struct Node {
        LaneArray lx, ly, lz, hx, hy, hz; ///< rounded outward; low above high for an unused child
        std::int32_t child[kLanes] = {};  ///< >= 0 an inner node, < 0 the complement of a leaf
    };

    BoxTree(const TriangleSoup& soup, Division division);

    const std::vector<Node>& nodes() const { return nodes_; }
    const std::vector<SphereTree::Leaf>& leaves() const { return leaves_; }
    std::size_t bytes() const {
        return nodes_.size() * sizeof(Node) + leaves_.size() * sizeof(SphereTree::Leaf);
    }

private:
    std::vector<Node> nodes_;
    std::vector<SphereTree::Leaf> leaves_;
};

} // namespace tactum::bench
