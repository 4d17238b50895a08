// Saves a scene as the file that opens as the same scene.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/scene/scene.h"

namespace tactum {

/// The ending of the program's own files, without dot.
inline constexpr const char* kSceneEnding = "glb";

/// Writes the scene as .glb, whole or not at all, with the last `backups` versions beside it, three if
/// nothing else is said. A file that a later
/// major version of the format wrote is not replaced: what this version does not know would be lost. Errors:
/// one line with the path and the remedy. Thread: any but real time.
Result<void> saveScene(const Scene& scene, const std::filesystem::path& file, const Progress& progress = {});
Result<void> saveScene(const Scene& scene, const std::filesystem::path& file, const Progress& progress,
                       int backups);

/// Error for a file that holds a scene of a later major version of the format, which must not be replaced.
Result<void> demandReplaceable(const std::filesystem::path& file);

/// The version of the format that a later program wrote these bytes in; none for ours, and for what is no
/// glTF file.
std::optional<std::string> laterSceneFormat(std::string_view bytes);

} // namespace tactum
