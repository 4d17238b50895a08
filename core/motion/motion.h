// How a body moves by itself: keys over time, as an animation has them.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/vec.h"

namespace tactum {

/// What holds between two keys: the earlier value, the straight (for rotations the shortest) way, or the
/// cubic with the keys' tangents. The same three as in glTF 2.0.
enum class Interpolation : std::uint8_t { Step, Linear, CubicSpline };

/// One quantity over time. Before the first key it has the first value, after the last one the last.
template <class Value> struct Track {
    Interpolation interpolation = Interpolation::Linear;
    std::vector<double> times; ///< s, never falling; two equal ones are a jump
    std::vector<Value> values; ///< one for each key
    /// CubicSpline alone: the slopes on arriving at and on leaving each key, in units of the value for each
    /// s.
    std::vector<Value> arriving, leaving;

    bool operator==(const Track&) const = default;
};

/// The coefficients x, y, z, w of a quaternion: of unit length at a key, anything as a slope.
using QuatCoefficients = Eigen::Vector4d;

/// A rigid motion relative to the body's rest pose: X_WB(t) = rest * at(t). A track without keys stands
/// still. Made by makeMotion() (motion_build.h), immutable afterwards.
struct Motion {
    Track<Vec3> translation;          ///< m, in the frame of the rest pose
    Track<QuatCoefficients> rotation; ///< about the origin of the body
    double duration = 0;              ///< s; the motion starts again after it. 0: it never does
    std::vector<double> jumps;        ///< s, rising: where the pose is not continuous
    bool jumpsAtEnd = false;          ///< the last pose is not the first one

    /// The pose at a time in s, its rotation of unit length; what is before 0 is at 0.
    /// Thread: real time; two binary searches.
    Pose at(double t) const noexcept;
    /// Whether the pose jumps after `before` and not later than `now`. Thread: real time.
    bool jumpsBetween(double before, double now) const noexcept;

    bool operator==(const Motion&) const = default;

private:
    double looped(double t) const noexcept;
};

/// Points in whose convex hull a track stays; the origin for one without keys. Of a cubic these are the
/// control points of its Bezier curves. Thread: any but real time.
std::vector<Vec3> controlPoints(const Track<Vec3>& track);

} // namespace tactum
