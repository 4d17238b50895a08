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
    double airDensity = 0;              ///< kg/m^3, of what bodies move through; 0: nothing

    bool operator==(const Mechanics&) const = default;
};

/// The same with `about` moved to the origin and then every length multiplied; masses, forces,
/// stiffnesses and the density of the air stay. Thread: any but real time.
Mechanics scaled(Mechanics mechanics, double factor, const Vec3& about);

} // namespace tactum
