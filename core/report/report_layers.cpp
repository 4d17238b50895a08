#include "core/report/report_layers.h"

#include <algorithm>
#include <cmath>

#include "core/bundle/preview.h"
#include "core/files/images/write_png.h"
#include "core/report/html.h"
#include "core/surface/pattern_picture.h"

namespace tactum {

namespace {

constexpr int kWidth = 480, kHeight = 360, kPatternPixels = 128; // pixels

std::string withUnit(const ParameterDescription& parameter) {
    const auto [number, unit] = quantity(parameter.value, parameter.unit);
    return number + (unit.empty() ? "" : " ") + unit;
}

Row rowOf(const LayerDescription& layer) {
    return {layer.name + (layer.enabled ? "" : " (off)"),
            std::string(layer.source) + (layer.image.empty() ? "" : " " + layer.image),
            std::string(layer.mapping),
            std::string(layer.target),
            withUnit(layer.strength),
            std::string(layer.blend),
            readable(layer.opacity.value),
            layer.mask.empty() ? "none" : std::string(layer.mask)};
}

std::string pngOf(const PatternPicture& pattern) {
    std::vector<std::uint16_t> greys;
    for (const double value : pattern.values)
        greys.push_back(std::uint16_t(std::lround(65535 * std::clamp(value, 0.0, 1.0))));
    return encodePng(pattern.pixels, pattern.pixels, 1, 8, greys);
}

std::string patterns(const Surface& surface) {
    std::string text;
    for (const TextureLayer& layer : surface.layers) {
        const PatternPicture pattern = patternOnFlatGround(layer.pattern, kPatternPixels);
        if (pattern.values.empty()) continue;
        const std::string what = "Layer " + layer.name + ", " + readable(1e3 * pattern.side) + " mm across";
        text += paragraph(what) +
                picture("image/png", pngOf(pattern), what + ": light is high, dark is low", kPatternPixels);
    }
    return text;
}

std::string surfacePart(const Surface& surface, const SurfaceDescription& described) {
    if (surface.layers.empty()) return {};
    std::vector<Row> rows;
    for (const LayerDescription& layer : described.layers)
        rows.push_back(rowOf(layer));
    return heading(4, "Surface " + surface.name) +
           table({"layer, lowest first", "source", "mapping", "changes", "strength", "blend", "opacity",
                  "mask"},
                 rows) +
           patterns(surface);
}

/// Alone, as large as the picture.
std::string pictureOf(const SceneObject& object) {
    Scene alone;
    alone.objects = {object};
    alone.objects.front().visible = true;
    return picture("image/png", previewOf(alone, kWidth, kHeight),
                   object.name + ", seen from the front, the right and above", kWidth);
}

} // namespace

std::string layersSection(const Scene& scene, const SceneDescription& described) {
    std::string text;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const SceneObject& object = scene.objects[i];
        std::string parts;
        for (std::size_t s = 0; s < object.surfaces.size(); ++s)
            parts += surfacePart(object.surfaces[s], described.objects[i].surfaces[s]);
        if (!parts.empty()) text += heading(3, "Object " + object.name) + pictureOf(object) + parts;
    }
    return text.empty() ? text : heading(2, "Layers of texture") + text;
}

} // namespace tactum
