#include "core/presets/preset.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/files/gltf/gltf_surface.h"

namespace tactum {
namespace {

bool fits(const TexturePattern& pattern) {
    return !pattern.image || (pattern.image->width() <= kLargestPresetPicture &&
                              pattern.image->height() <= kLargestPresetPicture);
}

bool canTravel(const TexturePattern& pattern) {
    if (pattern.source == TextureSource::Painted) return false;
    return pattern.source != TextureSource::Image || (pattern.image && fits(pattern));
}

std::string whyNot(const TexturePattern& pattern) {
    if (pattern.source == TextureSource::Painted) return "is painted on this mesh";
    if (!pattern.image) return "has no picture";
    return "has a picture of more than " + std::to_string(kLargestPresetPicture) + " texels a side";
}

/// Without what the source that is chosen does not use.
TexturePattern bare(TexturePattern pattern) {
    pattern.painted.values = nullptr;
    if (pattern.source != TextureSource::Image) pattern.image = nullptr;
    return pattern;
}

/// Empty where the layer belongs to its mesh.
std::optional<TextureLayer> travelling(TextureLayer layer, std::vector<std::string>& notes) {
    const std::string name = "Layer " + inQuotes(layer.name);
    if (!canTravel(layer.pattern)) {
        notes.push_back(name + " " + whyNot(layer.pattern) + " and stays out of the preset");
        return std::nullopt;
    }
    layer.pattern = bare(layer.pattern);
    if (!layer.mask) return layer;
    if (canTravel(*layer.mask)) {
        layer.mask = bare(*layer.mask);
        return layer;
    }
    notes.push_back(name + " goes without its mask, which " + whyNot(*layer.mask));
    layer.mask.reset();
    return layer;
}

double rounded(double value) {
    return std::round(value * 1e4) / 1e4;
}

} // namespace

const PresetSource& sourceOf(const Preset& preset, std::string_view key) {
    static const PresetSource kUnknown;
    const auto found = preset.sources.find(key);
    return found == preset.sources.end() ? kUnknown : found->second;
}

bool bringsColour(const Preset& preset) {
    const auto sets = [&](const Parameter& parameter) {
        const auto field = std::ranges::find(kMaterialFields, &parameter, &MaterialField::parameter);
        return preset.values[std::size_t(field - kMaterialFields.begin())].has_value();
    };
    return preset.colour && (sets(kStaticFriction) || sets(kDynamicFriction));
}

Surface applied(Surface surface, const Preset& preset) {
    for (std::size_t i = 0; i < kMaterialFields.size(); ++i)
        if (preset.values[i])
            surface.material = withValue(surface.material, kMaterialFields[i], *preset.values[i]);
    if (preset.shading) surface.shading = *preset.shading;
    if (preset.layers) surface.layers = *preset.layers;
    if (bringsColour(preset)) surface.colour = preset.colour->cast<float>();
    return surface;
}

LoadedPreset presetOf(const Surface& surface, std::string name, const PresetSource& source) {
    LoadedPreset made;
    Preset& preset = made.preset;
    preset.name = std::move(name);
    preset.colour = Vec3(surface.colour.cast<double>().unaryExpr(&rounded));
    Material inRange;
    for (std::size_t i = 0; i < kMaterialFields.size(); ++i) {
        const MaterialField& field = kMaterialFields[i];
        inRange = withValue(inRange, field, surface.material.*field.value);
        preset.sources[jsonKey(field.parameter->key)] = source;
    }
    for (std::size_t i = 0; i < kMaterialFields.size(); ++i)
        preset.values[i] = inRange.*kMaterialFields[i].value;
    preset.shading = surface.shading;
    preset.shading->creaseAngle = kCreaseAngle.clamped(surface.shading.creaseAngle);
    preset.layers.emplace();
    for (const TextureLayer& layer : surface.layers)
        if (auto whole = travelling(layer, made.notes)) preset.layers->push_back(std::move(*whole));
    preset.sources[kShadingPart] = preset.sources[kLayersPart] = source;
    return made;
}

} // namespace tactum
