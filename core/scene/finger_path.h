// A recorded finger: rows of time and position, read from and written as CSV.
#pragma once

#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/base/vec.h"

namespace tactum {

struct FingerPoint {
    double t = 0;                 ///< s, strictly rising
    Vec3 position = Vec3::Zero(); ///< m, world frame
};

/// Reads "t,x,y,z" with a header line, from a file or a pipe. Numbers in the C locale; every one finite; t
/// strictly rising. Errors name the line and the column. Thread: any but real time.
Result<std::vector<FingerPoint>> readFingerPath(const std::filesystem::path& file);

} // namespace tactum
