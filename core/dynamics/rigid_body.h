// A body with mass: what the author says of it. Plain values with ==.
#pragma once

#include <cstdint>
#include <string>

#include "core/base/vec.h"

namespace tactum {

/// Names a body for its whole life. 0 is the world, which is fixed.
using BodyId = std::uint32_t;
inline constexpr BodyId kWorldBody = 0;

struct RigidBody {
    BodyId id = kWorldBody;
    std::string name;
    Pose pose;                            ///< X_WN at the time 0: of the frame that all below is given in
    double mass = 1;                      ///< kg; 0: nothing moves it
    Vec3 centre = Vec3::Zero();           ///< of mass, m, body frame
    Vec3 inertia = Vec3::Ones();          ///< principal moments about the centre, kg m^2; 0: infinite
    Quat inertiaFrame = Quat::Identity(); ///< from the principal axes to the body frame
    Vec3 velocity = Vec3::Zero();         ///< of the centre at the time 0, m/s, world frame
    Vec3 angularVelocity = Vec3::Zero();  ///< at the time 0, rad/s, world frame
    double gravityFactor = 1;             ///< how much of the scene's gravity it feels
    bool kinematic = false;               ///< goes on with its velocity whatever happens

    bool operator==(const RigidBody& other) const {
        return id == other.id && name == other.name && pose == other.pose && mass == other.mass &&
               centre == other.centre && inertia == other.inertia &&
               inertiaFrame.coeffs() == other.inertiaFrame.coeffs() && velocity == other.velocity &&
               angularVelocity == other.angularVelocity && gravityFactor == other.gravityFactor &&
               kinematic == other.kinematic;
    }
};

} // namespace tactum
