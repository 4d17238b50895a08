// Covers primitives with leaf spheres (section 5): one for a compact triangle, several for a long one.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/triangle.h"
#include "core/geometry/triangle_soup.h"

namespace tactum {

/// A leaf sphere and the primitive that it covers, or a part of it. Single precision, rounded outward.
struct LeafSphere {
    Eigen::Vector3f centre;
    float radius;
    Index triangle;
    std::uint32_t piece; ///< which part: 1 the whole, 2 k and 2 k + 1 the halves of k
};

/// The part of a triangle that a piece number names. Thread: any.
Triangle pieceOf(const Triangle& triangle, std::uint32_t piece);

/// What a leaf sphere covers, as seen from `origin`. Thread: any.
Triangle partOf(const LeafSphere& sphere, const TriangleSoup& soup, const Vec3& origin);

/// A centre in single precision; distances have to be measured from where it then is. Thread: any.
Eigen::Vector3f roundedCentre(const Vec3& centre);

/// The square root, rounded up to single precision. Thread: any.
float radiusAbove(double distance2);

/// Leaf spheres whose union holds every triangle of the soup, in the order of the triangles; their centres as
/// seen from `origin`. Thread: any but real time; uses all cores.
std::vector<LeafSphere> coverWithSpheres(const TriangleSoup& soup, const Vec3& origin = Vec3::Zero());

} // namespace tactum
