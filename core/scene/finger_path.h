// A recorded finger: rows of time and position, written as CSV.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/vec.h"

namespace tactum {

struct FingerPoint {
    double t = 0;                 ///< s, strictly rising
    Vec3 position = Vec3::Zero(); ///< m, world frame

    bool operator==(const FingerPoint&) const = default;
};

/// Whether the times rise strictly and every number is finite and within reach. Not for an empty path.
bool isFingerPath(std::span<const FingerPoint> points);

/// The text that reads back as the same points.
std::string fingerCsv(std::span<const FingerPoint> points);

} // namespace tactum
