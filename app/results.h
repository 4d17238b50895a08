// What the verbs write: files, and the touch as CSV.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/base/result.h"
#include "core/haptics/replay.h"
#include "core/scene/findings.h"

namespace tactum {

/// The columns of the contract, full double precision.
std::string touchCsv(const TouchTrace& rows);
/// "-": standard output, and for a scene that is read standard input.
bool isDash(const std::optional<std::filesystem::path>& file);
/// One line on standard error; returns the exit code that goes with it.
int sayError(const Error& error);
/// The same for all of them; what is said of more than three objects is said of the first, and the others are
/// counted.
std::vector<std::string> linesOf(const std::vector<Finding>& findings);
/// An array of objects with severity, object, sentence and remedy.
nlohmann::ordered_json findingsJson(const std::vector<Finding>& findings);

/// To a file, or to standard output.
Result<void> writeFile(const std::filesystem::path& file, const std::string& text);

} // namespace tactum
