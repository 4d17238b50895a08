// A ball, a capsule or a cylinder where it is, and how far points are from it. World frame, m. For this
// folder. Thread: real time.
#pragma once

#include <cmath>

#include "core/dynamics/convex.h"

namespace tactum {

/// The sine of the angle up to which two bodies lie side by side, and touch along a stretch; and up to which
/// no place of it is nearer than its ends.
inline constexpr double kAlongside = 0.1, kParallel = 1e-3;

struct RoundBody {
    Vec3 centre = Vec3::Zero();
    Vec3 axis = Vec3::UnitY(); ///< of unit length
    double half = 0;           ///< along it, to both sides; 0 for a ball
    double radius = 0;

    Vec3 at(double along) const noexcept { return centre + along * axis; }
    double alongOf(const Vec3& point) const noexcept { return axis.dot(point - centre); }
};
RoundBody roundBodyOf(const Convex& convex, const Pose& pose) noexcept;

/// From a point to a body: how far, below 0 inside, and the way from the body to the point.
struct Clearance {
    double gap = 0;
    Vec3 out = Vec3::UnitY(); ///< of unit length
};
/// From the endless side of a cylinder.
Clearance fromSide(const RoundBody& cylinder, const Vec3& point) noexcept;
Clearance fromCylinder(const RoundBody& cylinder, const Vec3& point) noexcept;

/// What both have of the axis of a, along it; nothing where `high` is not above `low`.
struct Stretch {
    double low = 0, high = 0;
    double length() const noexcept { return high - low; }
};
Stretch sharedStretch(const RoundBody& a, const RoundBody& b) noexcept;

} // namespace tactum
