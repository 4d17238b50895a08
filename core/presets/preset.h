// A named feel that can be given to any surface: the values that it sets, and where each of them comes from.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace tactum {

/// Where a value comes from, for the person who relies on it.
struct PresetSource {
    std::string words;    ///< a citation, or whose choice it was
    std::string link;     ///< an address on the web; may be empty
    bool typical = false; ///< other tables disagree with it

    bool operator==(const PresetSource&) const = default;
};

/// The keys of a preset's sources beside those of its values, which are spelled as in files.
inline constexpr const char *kShadingPart = "shading", *kLayersPart = "layers";

/// Sets some values of a surface and leaves the others alone.
struct Preset {
    std::string name;
    std::string category; ///< may be empty
    std::vector<std::string> tags;
    std::optional<Vec3> colour; ///< linear RGB, 0 to 1: what the material looks like
    /// In the order and the units of kMaterialFields; empty for what it does not set.
    std::array<std::optional<double>, kMaterialFields.size()> values;
    std::optional<Shading> shading;
    std::optional<std::vector<TextureLayer>> layers; ///< in place of the surface's own; none is painted
    std::map<std::string, PresetSource, std::less<>> sources; ///< by key of a value, or a part above
    std::shared_ptr<const std::string> kept; ///< the file that it came from, for what is not known here
};

/// What is known of one part; empty words where nothing is.
const PresetSource& sourceOf(const Preset& preset, std::string_view key);

/// Whether surfaces take its colour: it has one, and the friction of a material. A stiffness or a pattern
/// alone is of no material.
bool bringsColour(const Preset& preset);

/// The surface with the preset's values. Of the two friction coefficients the one that is not set follows, so
/// that dynamic never exceeds static. The colour becomes the preset's where the preset bringsColour(). Name,
/// sides and lock stay the surface's own.
Surface applied(Surface surface, const Preset& preset);

/// A preset, and sentences about what could not become a part of it.
struct LoadedPreset {
    Preset preset;
    std::vector<std::string> notes;
};

/// Everything that can be felt of a surface, all from one source. What is painted belongs to one mesh and is
/// left out, and so are pictures with more than kLargestPresetPicture texels a side; notes say so.
LoadedPreset presetOf(const Surface& surface, std::string name, const PresetSource& source);
inline constexpr int kLargestPresetPicture = 2048;

} // namespace tactum
