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
    // How a hand meets what is much smaller or larger than it. All else stays in the world's own SI.
    double forceScale = 1; ///< N on a body for each N of the finger
    double timeScale = 1;  ///< s of the bodies and of all motions for each s of the hand

    bool operator==(const Mechanics&) const = default;
};

/// With every length multiplied: of a shape, and of a joint its frames, its path, and what is linear of its
/// limits and drives.
ColliderShape scaled(ColliderShape shape, double factor);
void scaleLengths(Joint& joint, double factor);

/// The same with `about` moved to the origin and then every length multiplied; masses, forces,
/// stiffnesses and the density of the air stay. Thread: any but real time.
Mechanics scaled(Mechanics mechanics, double factor, const Vec3& about);

} // namespace tactum
