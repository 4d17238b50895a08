// The bounding-sphere hierarchy of section 5, in wide nodes that one vector instruction tests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/vec.h"
#include "core/geometry/triangle.h"
#include "core/geometry/triangle_soup.h"

namespace tactum {

/// A sphere of the hierarchy, for display. Body frame, metre.
struct BoundingSphere {
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();
    float radius = 0;
};

/// Where a moving sphere first touches a mesh.
struct SweepHit {
    double t = kNoContact; ///< in [0, 1]
    Index triangle = 0;    ///< index into the soup
    Index leaf = 0;        ///< the leaf node it was found in: the hint for the next sweep nearby
};

/// The moving sphere of a sweep: its centre goes from `from` to `from + motion`. Body frame, metre.
struct SpherePath {
    Vec3 from = Vec3::Zero();
    Vec3 motion = Vec3::Zero();
    double radius = 0;
};

class SphereTree {
public:
    static constexpr int kWidth = 8;
    using Lane = Eigen::Array<float, kWidth, 1>;

    /// Eight children in structure-of-arrays, single precision, rounded outward. Each is a sphere; a flat one
    /// also lies between two planes, |n . (p - centre) - offset| <= thickness, so that together they are a
    /// coin. n = 0 where there is no such pair.
    struct Node {
        Lane x, y, z, radius; ///< radius -1e30 for an unused child: nothing is ever near it
        Lane nx, ny, nz, offset, thickness;
        /// Inner nodes: >= 0 an inner node, < 0 the complement of a leaf node. Leaf nodes: the primitive that
        /// the leaf sphere covers, or covers a part of.
        std::int32_t child[kWidth];
    };

    SphereTree() = default;
    /// Builds over every triangle of the soup, on all cores. Keeps no reference to the soup.
    /// Thread: any but real time. O(n log n).
    explicit SphereTree(const TriangleSoup& soup);

    /// First contact of a moving sphere with the soup that the tree was built over, leaving out the
    /// triangles in `excluded`. Of several at the same time, any. The leaf `hint` is looked at first:
    /// coherence of successive sweeps shortens the path before the descent; it never changes what is found
    /// but among ties. Thread: real time; fixed stack, no allocation.
    SweepHit sweep(const TriangleSoup& soup, const SpherePath& path, std::span<const Index> excluded,
                   Index hint = 0) const noexcept;

    const std::vector<Node>& nodes() const { return nodes_; }
    const std::vector<Node>& leaves() const { return leaves_; }
    std::size_t bytes() const { return (nodes_.size() + leaves_.size()) * sizeof(Node); }
    /// The spheres at one depth below the root's children (0), for display.
    std::vector<BoundingSphere> spheresAt(int depth) const;

private:
    std::vector<Node> nodes_; ///< the root is the first; empty when there are no triangles
    std::vector<Node> leaves_;
};

} // namespace tactum
