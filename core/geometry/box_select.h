// Triangles that lie in a rectangle of the screen.
#pragma once

#include <Eigen/Core>

#include "core/geometry/triangle_set.h"
#include "core/geometry/triangle_soup.h"

namespace tactum {

/// In normalised device coordinates: -1 to 1 from left to right and from bottom to top.
struct ScreenBox {
    double left = -1, bottom = -1, right = 1, top = 1;
};

/// Which triangles a box takes.
struct BoxRule {
    bool whole = false;     ///< only those that lie in it entirely; else those that touch it
    bool frontOnly = false; ///< only those whose front looks to the eye; what stands before them is not asked
};

/// `clipFromBody`: projection times view times the object's pose, column vectors, clip space as OpenGL has
/// it. What lies before the near plane is not on the screen; beyond the far plane is. Exact: a triangle is
/// cut to the box's pyramid where its corners do not tell. Segments and points too; they have no front. Cost:
/// about 20 ms for a million triangles that share vertices, 100 ms when each has its own. Thread: any but
/// real time.
TriangleSet trianglesInBox(const TriangleSoup& soup, const Eigen::Matrix4d& clipFromBody,
                           const ScreenBox& box, BoxRule rule = {});

} // namespace tactum
