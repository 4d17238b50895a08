// All that moves by forces in a scene: what an author edits and compileMechanism() reads.
#pragma once

#include <vector>

#include "core/dynamics/collider.h"
#include "core/dynamics/joint.h"
#include "core/dynamics/rigid_body.h"

namespace tactum {

/// Of the Earth, along -y as in glTF, m/s^2.
inline constexpr double kEarthGravity = 9.81;

struct Mechanics {
    std::vector<RigidBody> bodies;
    std::vector<Joint> joints;
    std::vector<Collider> colliders;
    Vec3 gravity{0, -kEarthGravity, 0}; ///< m/s^2, world frame

    bool operator==(const Mechanics&) const = default;
};

} // namespace tactum
