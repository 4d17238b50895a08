// Where the values of a surface come from. For this folder only.
#pragma once

#include <span>
#include <string>

#include "core/presets/preset.h"

namespace tactum {

/// Of the presets that set what this surface has the one that sets most; null where there is none. A scene
/// does not keep which preset was given to a surface, and what has been changed since is none of it.
const Preset* presetOfSurface(const Surface& surface, std::span<const Preset> presets);

/// "Preset Brick: Smith 2001, table 2, https://..."; empty where the preset says nothing of that value.
/// `key`: of a parameter, or a part of preset.h.
std::string sourceText(const Preset& preset, std::string_view key);

} // namespace tactum
