// A recorded finger: rows of time and position, read from and written as CSV.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/vec.h"

namespace tactum {

struct FingerPoint {
    double t = 0;                 ///< s, strictly rising
    Vec3 position = Vec3::Zero(); ///< m, world frame

    bool operator==(const FingerPoint&) const = default;
};

/// Whether the times rise strictly and every number is finite and within reach. Not for an empty path.
bool isFingerPath(std::span<const FingerPoint> points);

/// Reads "t,x,y,z" with a header line, from a file or a pipe. Numbers in the C locale; every one finite; t
/// strictly rising. Errors name the line and the column. Thread: any but real time.
Result<std::vector<FingerPoint>> readFingerPath(const std::filesystem::path& file);
/// The same of text in memory; `where` is named in errors.
Result<std::vector<FingerPoint>> readFingerPath(std::string_view text, const std::filesystem::path& where);

/// The text that reads back as the same points.
std::string fingerCsv(std::span<const FingerPoint> points);

} // namespace tactum
