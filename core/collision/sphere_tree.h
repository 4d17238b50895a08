// The bounding-sphere hierarchy of section 5, in wide nodes that one vector instruction tests.
#pragma once

#include <array>
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
    Eigen::Vector3f centre;
    float radius;
    int depth; ///< 0 at the root
};

/// Where a moving sphere first touches a mesh.
struct SweepHit {
    double t = 2.0;      ///< in [0, 1]; kNoContact when nothing is touched
    Index triangle = 0;  ///< index into the soup
};

class SphereTree {
public:
    static constexpr int kWidth = 8;

    SphereTree() = default;
    /// Builds over every triangle of the soup, in parallel. Keeps no reference to the soup.
    /// Thread: any but real time.
    explicit SphereTree(const TriangleSoup& soup);

    /// First contact of a sphere of radius r whose centre moves from p to p + d (body frame, metre) with
    /// the soup that the tree was built over, leaving out the triangles in `excluded`.
    /// Thread: real time; fixed stack, no allocation.
    SweepHit sweep(const TriangleSoup& soup, const Vec3& p, const Vec3& d, double r,
                   std::span<const Index> excluded) const noexcept;

    /// Bytes held by the nodes.
    std::size_t bytes() const;
    /// The spheres of one depth, for display; all leaves above that depth are included.
    std::vector<BoundingSphere> spheresAt(int depth) const;
    bool empty() const { return leaves_.empty(); }

    // One inner node: eight child spheres in structure-of-arrays, single precision, rounded outward.
    // child < 0: leaf node ~child; unused children have radius -1.
    struct alignas(32) Node {
        std::array<float, kWidth> x, y, z, radius;
        std::array<std::int32_t, kWidth> child;
    };
    // One leaf node: up to eight leaf spheres, each with its primitive and the primitive's plane.
    struct alignas(32) Leaf {
        std::array<float, kWidth> x, y, z, radius;     ///< leaf spheres
        std::array<float, kWidth> nx, ny, nz, offset;  ///< n . (p - sphere centre) = offset; n = 0 for segments
        std::array<std::uint32_t, kWidth> triangle;
    };

private:
    std::vector<Node> nodes_;
    std::vector<Leaf> leaves_;
    std::int32_t root_ = 0;
    float reach_ = 0; ///< largest coordinate, for the rounding margin of the plane test
};

} // namespace tactum
