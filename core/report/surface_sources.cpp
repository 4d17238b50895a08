#include "core/report/surface_sources.h"

#include "core/files/gltf/gltf_surface.h"

namespace tactum {

namespace {

/// How many values of the surface the preset explains; 0 where one of them is another.
int explainedBy(const Surface& surface, const Preset& preset) {
    int count = 0;
    for (std::size_t i = 0; i < kMaterialFields.size(); ++i) {
        if (!preset.values[i]) continue;
        if (*preset.values[i] != surface.material.*kMaterialFields[i].value) return 0;
        ++count;
    }
    if (preset.layers && *preset.layers == surface.layers) count += int(surface.layers.size());
    return count;
}

} // namespace

const Preset* presetOfSurface(const Surface& surface, std::span<const Preset> presets) {
    const Preset* best = nullptr;
    int most = 1; // one number may be the same by chance
    for (const Preset& preset : presets)
        if (const int count = explainedBy(surface, preset); count > most) {
            best = &preset;
            most = count;
        }
    return best;
}

std::string sourceText(const Preset& preset, std::string_view key) {
    const bool isPart = key == kShadingPart || key == kLayersPart;
    const PresetSource& source = sourceOf(preset, isPart ? std::string(key) : jsonKey(key));
    if (source.words.empty()) return {};
    std::string text = "Preset " + preset.name + ": " + source.words;
    if (source.typical) text += " (other tables disagree)";
    if (!source.link.empty()) text += ", " + source.link;
    return text;
}

} // namespace tactum
