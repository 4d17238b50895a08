// The part of a mesh that is nearest to a point, and on which side of it the point is.
#pragma once

#include <limits>
#include <span>

#include "core/collision/collision_mesh.h"
#include "core/geometry/sides.h"

namespace tactum {

struct Nearest {
    double distance = std::numeric_limits<double>::infinity(); ///< m; infinity: nothing within reach
    Index triangle = 0;
    Vec3 point = Vec3::Zero(); ///< body frame
    /// Cosine between the normal there and the way from `point` to where was asked: positive in front. On an
    /// edge the normal is the mean of its faces', on a vertex that weighted by their angles, so that the sign
    /// tells outside from inside for every closed mesh (Baerentzen and Aanaes 2005).
    double front = 0;
};

/// `p_B` in the body frame, `within` in metres: what is farther away is not found; nor are surfaces that are
/// felt from no side. `sides`: one for each surface, or none when all are felt.
/// Thread: real time; fixed stack. For changes of the scene, and for each move over what is felt from one
/// side alone; anything else sweeps.
Nearest nearestOn(const CollisionMesh& mesh, const Vec3& p_B,
                  double within = std::numeric_limits<double>::infinity(),
                  std::span<const Sides> sides = {}) noexcept;

} // namespace tactum
