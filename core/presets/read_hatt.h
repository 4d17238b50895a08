// A texture model of the Penn Haptic Texture Toolkit as a preset. Its licence forbids passing its data on, so
// the models are a user's own copy.
#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/result.h"
#include "core/presets/preset.h"

namespace tactum {

/// Friction as measured; the relief from the model nearest to the middle of the speeds and forces, where the
/// set has autoregressive models alone. Notes and the preset's sources say what was carried over.
/// Errors: one line that names the file, the place in it and the remedy. Thread: any but real time.
Result<LoadedPreset> readHatt(const std::filesystem::path& file);
/// The same of a text in memory; `where` stands for it in the error.
Result<LoadedPreset> parseHatt(std::string_view text, const std::filesystem::path& where);

} // namespace tactum
