// Covers primitives with leaf spheres (section 5): one for a compact triangle, several for a long one.
#pragma once

#include <vector>

#include "core/geometry/triangle_soup.h"

namespace tactum {

/// A leaf sphere and the primitive that it covers, or a part of it. Single precision, rounded outward.
struct LeafSphere {
    Eigen::Vector3f centre;
    float radius;
    Index triangle;
};

/// Leaf spheres whose union holds every triangle of the soup, in the order of the triangles.
/// Thread: any but real time; uses all cores.
std::vector<LeafSphere> coverWithSpheres(const TriangleSoup& soup);

} // namespace tactum
