// Finger paths from CSV.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/scene/finger_path.h"

namespace tactum {

/// Reads "t,x,y,z" with a header line, from a file or a pipe. Numbers in the C locale; every one finite; t
/// rising by 1e-7 s or more. Errors name the line and the column. Thread: any but real time.
Result<std::vector<FingerPoint>> readFingerPath(const std::filesystem::path& file);
/// The same of text in memory; `where` is named in errors.
Result<std::vector<FingerPoint>> readFingerPath(std::string_view text, const std::filesystem::path& where);

} // namespace tactum
