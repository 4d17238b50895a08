// What holds two bodies together: as in KHR_physics_rigid_bodies a joint leaves everything free that no limit
// takes away, so that hinges, sliders, springs, ropes and cones are limits and drives of one kind of joint.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "core/dynamics/path.h"
#include "core/dynamics/rigid_body.h"

namespace tactum {

inline constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// Which axes of the joint: bits 0 to 2 are x, y and z.
using AxisSet = std::uint8_t;
inline constexpr AxisSet kAllAxes = 7;

/// Bounds of how far frame b may be from frame a. Of one linear axis its signed distance counts, of two or
/// three the length; of one angular axis the turn about it, of two the angle between the third axes, of three
/// the angle of the whole turn.
struct JointLimit {
    bool angular = false;
    AxisSet axes = kAllAxes;
    double min = -kUnbounded, max = kUnbounded; ///< m or rad
    double stiffness = kUnbounded;              ///< N/m or N m/rad beyond the bounds; unbounded: hard
    double damping = 0;                         ///< N s/m or N m s/rad there, of a soft limit

    bool isHard() const { return stiffness == kUnbounded; }
    bool isLock() const { return isHard() && min == max; }
    bool operator==(const JointLimit&) const = default;
};

/// A spring with a damper and a bound on what it can do: a motor, a return spring, detents, viscous friction.
/// Its force on b is stiffness * (position - x) + damping * (velocity - x').
struct JointDrive {
    bool angular = false;
    int axis = 0;
    double stiffness = 0;         ///< N/m or N m/rad
    double damping = 0;           ///< N s/m or N m s/rad
    double position = 0;          ///< m or rad
    double velocity = 0;          ///< m/s or rad/s
    double maxForce = kUnbounded; ///< N or N m
    bool acceleration = false;    ///< the force counts for each kg or kg m^2 that it moves
    /// m or rad: it rests at `position` and every so far from it, in detents. Its force is that of the spring
    /// next to each, and goes through zero half way to the next: -k s / 2 pi sin(2 pi (x - position) / s). 0:
    /// none.
    double spacing = 0;

    /// Where a spring of its stiffness would rest that pulls as it does at x: m or rad.
    double restAt(double x) const;
    /// J, for each N/m or N m/rad of stiffness.
    double energyAt(double x) const;
    bool operator==(const JointDrive&) const = default;
};

inline double JointDrive::restAt(double x) const {
    if (spacing == 0) return position;
    const double turn = spacing / (2 * std::numbers::pi);
    return x - turn * std::sin((x - position) / turn);
}

inline double JointDrive::energyAt(double x) const {
    if (spacing == 0) return 0.5 * (x - position) * (x - position);
    const double turn = spacing / (2 * std::numbers::pi);
    return turn * turn * (1 - std::cos((x - position) / turn));
}

/// Dry friction of the joint itself: up to `force` it stays, beyond it goes against that force.
struct JointFriction {
    bool angular = false;
    int axis = 0;
    double force = 0; ///< N or N m

    bool operator==(const JointFriction&) const = default;
};

struct Joint {
    std::string name;
    BodyId a = kWorldBody, b = kWorldBody;
    Pose frameA, frameB; ///< in the frame of each body
    std::vector<JointLimit> limits;
    std::vector<JointDrive> drives;
    std::vector<JointFriction> frictions;
    bool collide = false; ///< whether a and b touch each other
    /// Of a joint to the world: which of the things that stand still (Collider::part) it is fixed to; 0: to
    /// none, and all of them are touched.
    std::uint32_t part = 0;
    /// A curve in frame a that the origin of frame b rides on, with x of b along it and y up: all that is
    /// free is the way from its first point, which limits, drives and frictions of the linear axis x are
    /// about; those of other axes do nothing. At the time 0 b is put onto it where it is nearest.
    JointPath path;

    bool operator==(const Joint&) const = default;
};

} // namespace tactum
