// What the verbs write: files, and the touch as CSV.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/runtime/replay.h"

namespace tactum {

/// The columns of the contract, full double precision.
std::string touchCsv(const TouchTrace& rows);
/// "-" is standard output.
bool isStandardOutput(const std::optional<std::filesystem::path>& file);
/// To a file, or to standard output.
Result<void> writeFile(const std::filesystem::path& file, const std::string& text);

} // namespace tactum
