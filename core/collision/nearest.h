// The part of a mesh that is nearest to a point, and on which side of it the point is.
#pragma once

#include <limits>

#include "core/collision/collision_mesh.h"

namespace tactum {

struct Nearest {
    double distance = std::numeric_limits<double>::infinity(); ///< m; infinity: nothing within reach
    Index triangle = 0;
    Vec3 point = Vec3::Zero(); ///< body frame
    /// Cosine between the triangle's normal and the way from `point` to where was asked: positive in front.
    /// Of several triangles at the same distance (an edge, a vertex) it is that of the one that is seen most
    /// from the front or the back: of a closed mesh its sign then tells outside from inside.
    double front = 0;
};

/// `p_B` in the body frame, `within` in metres: what is farther away is not found.
/// Thread: real time; fixed stack. Meant for changes of the scene, not for every step.
Nearest nearestOn(const CollisionMesh& mesh, const Vec3& p_B,
                  double within = std::numeric_limits<double>::infinity()) noexcept;

} // namespace tactum
