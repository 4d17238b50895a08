// Presets as files: JSON, in which a feel is written as in our extension of a glTF material. docs/presets.md
// says it in words.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/presets/preset.h"

namespace tactum {

/// The end of a preset's file name, without the dot.
inline constexpr std::string_view kPresetEnding = "tactum-preset";
/// Of the format. Another major number is another format, a higher minor one has members that we do not know.
inline constexpr int kPresetMajor = 1, kPresetMinor = 0;
inline constexpr std::uint64_t kLargestPreset = 32 << 20; ///< bytes of a file

/// Errors: one line that names the file, the place in it and the remedy. Thread: any but real time.
Result<LoadedPreset> readPreset(const std::filesystem::path& file);
/// The same of a text in memory; `where` stands for it in the error.
Result<LoadedPreset> parsePreset(std::string_view text, const std::filesystem::path& where);

/// What readPreset() makes the same preset of. The same preset gives the same text, and members of its file
/// that are not known here stay. Thread: any but real time.
std::string presetText(const Preset& preset);

/// A file name for a preset of this name: letters, digits and dashes, without the ending; never empty.
std::string presetFileName(std::string_view name);

} // namespace tactum
