// How far two frames of a joint are from each other, and which wrench works along that. For this folder.
#pragma once

#include "core/dynamics/mechanism.h"

namespace tactum {

/// A force at a point and a torque, world frame; on b, with the opposite on a.
struct Wrench {
    Vec3 force = Vec3::Zero();  ///< N
    Vec3 point = Vec3::Zero();  ///< m
    Vec3 torque = Vec3::Zero(); ///< N m
};

struct Measured {
    double value = 0; ///< m or rad
    /// How fast the value grows is the power of this wrench: its Jacobian.
    Wrench along;
};

/// Thread: real time.
Measured measure(const Coordinate& of, const Pose& a_W, const Pose& b_W) noexcept;

/// How a frame moves: rad/s, and m/s of its origin; world frame.
struct FrameVelocity {
    Vec3 angular = Vec3::Zero(), linear = Vec3::Zero();
};
/// A frame as it goes on. Thread: real time.
Pose ahead(const Pose& frame, const FrameVelocity& moves, double dt) noexcept;
/// The cosine of how far a direction may turn in half a step to be held where it points then.
inline constexpr double kTurnsLittle = 0.97;
/// How fast the wrench of measure() changes, of the measures that locks have. Thread: real time.
Wrench rateOf(const Coordinate& of, const Pose& a_W, const Pose& b_W, const FrameVelocity& a,
              const FrameVelocity& b) noexcept;

} // namespace tactum
