// Two touches of the same finger path held against each other: what an edit changes in what is felt.
#pragma once

#include <string>

#include "core/haptics/replay.h"

namespace tactum {

/// How the forces of a touch B differ from those of a touch A. SI, world frame.
struct TouchDifference {
    std::size_t steps = 0;
    double rms = 0;                   ///< N, of |F_B - F_A| over all steps
    double largest = 0;               ///< N, of the same
    double largestAt = 0;             ///< s
    Vec3 largestWhere = Vec3::Zero(); ///< m, of the finger then
    double workA = 0, workB = 0;      ///< J that the finger does against the force
    /// Mean of tangential over normal force while the finger is pushed; 0 where it never is.
    double ratioA = 0, ratioB = 0;

    bool operator==(const TouchDifference&) const = default;
};

/// What a device gives of a touch: the same directions, at most `maxForce`, N; none of it: no device is
/// known, and all of it is given.
void limitForces(TouchTrace& rows, double maxForce);

/// Both replays of one path, or of its beginning: the longer one counts as far as the shorter goes.
TouchDifference differenceOf(const TouchTrace& a, const TouchTrace& b);

/// One row for each step: time, finger, both forces, and the length of their difference.
std::string differenceCsv(const TouchTrace& a, const TouchTrace& b);

} // namespace tactum
