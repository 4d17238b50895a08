// Plain values: vectors, turns, poses and points of a finger path. The same layout whatever the compiler's
// flags.
#pragma once

#include <tactum/export.h>

namespace tactum::library {

/// A point in m, a velocity in m/s, a force in N or a direction. World frame, y up, where nothing else is
/// said.
struct Vec3 {
    double x = 0, y = 0, z = 0;

    bool operator==(const Vec3&) const = default;
};

/// A turn, of unit length; any other length but 0 is brought to it.
struct Quaternion {
    double w = 1, x = 0, y = 0, z = 0;

    bool operator==(const Quaternion&) const = default;
};

/// Where something is: takes points of its own frame to those of the world.
struct Pose {
    Vec3 position{}; ///< m
    Quaternion rotation{};

    bool operator==(const Pose&) const = default;
};

/// One row of a finger path.
struct FingerPoint {
    double t = 0;    ///< s, rising from row to row
    Vec3 position{}; ///< m, world frame

    bool operator==(const FingerPoint&) const = default;
};

} // namespace tactum::library
