// The bounding-sphere hierarchy of section 5, in wide nodes that one vector instruction tests.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/vec.h"
#include "core/collision/lane_array.h"
#include "core/geometry/sides.h"
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
    Index leaf = 0;        ///< the leaf it was found in: the hint for the next sweep nearby
    /// What the proxy touches next, the nearest first: triangles that are met shortly after this contact, or,
    /// of a short path without contact, that its end is near to.
    std::array<Index, 3> soon{};
    int soonCount = 0;
};

/// The moving sphere of a sweep: its centre goes from `from` to `from + motion`. Body frame, metre.
struct SpherePath {
    Vec3 from = Vec3::Zero();
    Vec3 motion = Vec3::Zero();
    double radius = 0;
    /// From where each surface of the soup is felt; empty: all from both sides.
    std::span<const Sides> sides{};
    Vec3 cameFrom = from; ///< the sphere counts as on the side of a surface that this place is on
    /// What is touched so little later, in radii, or is so near to where a free path ends is what the sphere
    /// slides onto next (SweepHit::soon).
    double lookAhead = 0.01;
};

struct Neighbourhood;
struct LeafPlanes;

class SphereTree {
public:
    static constexpr int kWidth = kLanes;

    /// Eight children in structure-of-arrays, single precision, rounded outward. Each is a sphere; a flat one
    /// also lies between two planes, |n . (p - centre) - offset| <= thickness, so that together they are a
    /// coin. n = 0 where there is no such pair.
    struct alignas(kCacheLine) Node {
        LaneArray x, y, z, radius; ///< radius -1e30 for an unused child: nothing is ever near it
        LaneArray nx, ny, nz, offset, thickness;
        std::int32_t child[kWidth] = {}; ///< >= 0 an inner node, < 0 the complement of a leaf
    };

    /// Eight primitives, or parts of long ones, rounded to single precision.
    struct alignas(kCacheLine) Leaf {
        LaneArray ax, ay, az, bx, by, bz, cx, cy, cz; ///< 1e15 for an unused lane: nothing is ever near it
        Index triangle[kWidth] = {};                  ///< index into the soup
    };

    SphereTree() = default;
    /// Builds over every triangle of the soup, on all cores. Keeps no reference to the soup.
    /// Thread: any but real time. O(n log n).
    explicit SphereTree(const TriangleSoup& soup);

    /// First contact of a moving sphere with the soup that the tree was built over, leaving out the
    /// triangles in `excluded`. Of several at the same time, any. The leaf `hint` is looked at first:
    /// coherence of successive sweeps shortens the path before the descent. With `near`, which must hold the
    /// path, the descent starts there. Leaves of which `planes` knows that they are out of the way are not
    /// looked at. None of them changes what is found but among ties. Thread: real time; fixed stack, no
    /// allocation.
    SweepHit sweep(const TriangleSoup& soup, const SpherePath& path, std::span<const Index> excluded,
                   Index hint = 0, const Neighbourhood* near = nullptr,
                   LeafPlanes* planes = nullptr) const noexcept;

    /// Collects what reaches into a ball, in as small pieces as there is room for. Body frame, metre.
    /// Thread: real time; at most Neighbourhood::kRoom nodes are opened.
    void gather(const Vec3& centre, double radius, Neighbourhood& near) const noexcept;

    /// Whether nothing of the mesh can be within `reach` of a point, by the spheres below the root. Body
    /// frame, metre. Thread: real time.
    bool isBeyond(const Vec3& p, double reach) const noexcept;

    /// What nodes and leaves are seen from: single precision has its digits there. Zero for a mesh that is
    /// not far from zero. Body frame, metre.
    const Vec3& origin() const { return origin_; }
    const std::vector<Node>& nodes() const { return nodes_; }
    const std::vector<Leaf>& leaves() const { return leaves_; }
    std::size_t bytes() const { return nodes_.size() * sizeof(Node) + leaves_.size() * sizeof(Leaf); }
    /// The spheres at one depth below the root's children (0), for display.
    std::vector<BoundingSphere> spheresAt(int depth) const;

private:
    Vec3 origin_ = Vec3::Zero();
    std::vector<Node> nodes_; ///< the root is the first; empty when there are no triangles
    std::vector<Leaf> leaves_;
};

/// What of one hierarchy reaches into a ball: a sweep inside the ball starts here instead of at the root.
struct Neighbourhood {
    static constexpr int kBlocks = 4;
    static constexpr int kRoom = kBlocks * SphereTree::kWidth;

    Vec3 centre = Vec3::Zero();
    double radius = -1;   ///< m; negative: nothing was gathered yet
    int blocks = 0;       ///< how many are in use
    bool crowded = false; ///< not everything could be opened down to the leaves
    std::array<SphereTree::Node, kBlocks> block;

    bool holds(const Vec3& p, double around) const noexcept {
        const double room = radius - around;
        return room >= 0 && (p - centre).squaredNorm() <= room * room;
    }
    /// Whether all that the moving sphere can touch was gathered.
    bool holds(const SpherePath& path) const noexcept {
        return holds(path.from, path.radius) && holds(path.from + path.motion, path.radius);
    }
};

} // namespace tactum
