// A curve that a body rides on, as an author gives it. Plain values with ==.
#pragma once

#include <vector>

#include "core/base/vec.h"

namespace tactum {

/// A smooth curve through points: splines of fifth degree over the lengths of the chords, with four
/// continuous derivatives; at an open end the third and the fourth are none.
struct JointPath {
    std::vector<Vec3> points; ///< m, frame a of the joint; none: the joint has no path
    /// At each point roughly where up is for what rides, of any length, never along the curve; none: it turns
    /// about the curve as little as can be, beginning with y up, and on a closed one evenly so much more that
    /// it ends as it began.
    std::vector<Vec3> ups;
    bool closed = false; ///< the last point leads to the first again; else the ends are hard stops

    bool isThere() const { return !points.empty(); }
    bool operator==(const JointPath&) const = default;
};

/// A path has no more points.
inline constexpr std::size_t kMostPathPoints = 2048;

} // namespace tactum
