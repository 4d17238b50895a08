#include "ui/tools/paint_goal.h"

#include "core/base/text.h"

namespace tactum {

namespace {

bool isValue(PaintGoal goal) {
    return goal != PaintGoal::Layer && goal != PaintGoal::Mask;
}

TextureTarget targetOf(PaintGoal goal) {
    static_assert(int(PaintGoal::Stiffness) == int(TextureTarget::Stiffness));
    return TextureTarget(goal);
}

bool isPaintable(const TexturePattern& pattern) {
    return pattern.source == TextureSource::Painted ||
           (pattern.source == TextureSource::Image && pattern.image && usesUvs(pattern));
}

Result<PaintPlace> placeOfValue(const Surface& surface, TextureTarget target) {
    const int count = int(surface.layers.size());
    for (int i = count - 1; i >= 0; --i) {
        const TextureLayer& layer = surface.layers[std::size_t(i)];
        if (layer.enabled && layer.target == target && layer.pattern.source == TextureSource::Painted)
            return PaintPlace{i, false};
    }
    if (count >= kMaxTextureLayers)
        return inputError(surface.name + " has " + std::to_string(count) +
                          " layers, more are not felt; remove one first.");
    return PaintPlace{count, false};
}

} // namespace

Result<PaintPlace> paintPlaceOf(const Surface& surface, PaintGoal goal, std::optional<int> current) {
    if (isValue(goal)) return placeOfValue(surface, targetOf(goal));
    if (surface.layers.empty())
        return inputError(surface.name + " has no layer: add one, or let the brush paint a value.");
    const int top = int(surface.layers.size()) - 1;
    const PaintPlace place{current && *current >= 0 && *current <= top ? *current : top,
                           goal == PaintGoal::Mask};
    const TextureLayer& layer = surface.layers[std::size_t(place.layer)];
    const TexturePattern* pattern = place.mask ? (layer.mask ? &*layer.mask : nullptr) : &layer.pattern;
    if (!pattern || isPaintable(*pattern)) return place;
    return inputError((place.mask ? "The mask of the layer " : "The layer ") + layer.name + " is " +
                      std::string(kTextureSources[std::size_t(pattern->source)].key) +
                      ", which cannot be painted: make it Painted" +
                      (place.mask ? ", or take the mask away." : ", or paint its mask."));
}

const TexturePattern* patternAt(const Surface& surface, PaintPlace place) {
    if (place.layer < 0 || place.layer >= int(surface.layers.size())) return nullptr;
    const TextureLayer& layer = surface.layers[std::size_t(place.layer)];
    const TexturePattern* pattern = place.mask ? (layer.mask ? &*layer.mask : nullptr) : &layer.pattern;
    return pattern && isPaintable(*pattern) ? pattern : nullptr;
}

bool scalesNothing(const Surface& surface, PaintGoal goal) {
    switch (goal) {
    case PaintGoal::StaticFriction:
        return surface.material.staticFriction == 0;
    case PaintGoal::DynamicFriction:
        return surface.material.dynamicFriction == 0;
    case PaintGoal::Viscosity:
        return surface.material.viscosity == 0;
    default:
        return false;
    }
}

void putPattern(Surface& surface, PaintPlace place, PaintGoal goal, const TexturePattern& pattern) {
    if (place.layer == int(surface.layers.size()) && isValue(goal)) {
        TextureLayer fresh;
        fresh.target = targetOf(goal);
        fresh.strength = strengthParameter(fresh.target).initial;
        fresh.name = "Painted " + lowerCase(kTextureTargets[std::size_t(fresh.target)].label);
        surface.layers.push_back(std::move(fresh));
    }
    if (place.layer < 0 || place.layer >= int(surface.layers.size())) return;
    TextureLayer& layer = surface.layers[std::size_t(place.layer)];
    if (place.mask)
        layer.mask = pattern;
    else
        layer.pattern = pattern;
}

} // namespace tactum
