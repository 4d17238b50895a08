// What the brush changes of a surface: which of its layers, and whether the layer itself or its mask.
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace tactum {

/// A value of the surface, by a painted layer of its own: those of TextureTarget, in that order. Or the layer
/// that is chosen, or its mask.
enum class PaintGoal { Height, StaticFriction, DynamicFriction, Viscosity, Stiffness, Layer, Mask };
inline constexpr auto kPaintGoals = [] {
    std::array<NamedChoice, kTextureTargets.size() + 2> all{};
    std::ranges::copy(kTextureTargets, all.begin());
    all[std::size_t(PaintGoal::Layer)] = {"layer", "Layer"};
    all[std::size_t(PaintGoal::Mask)] = {"mask", "Mask of layer"};
    return all;
}();

/// A layer of a surface; `layer` is that of a new one where it is the number of layers.
struct PaintPlace {
    int layer = 0;
    bool mask = false;

    bool operator==(const PaintPlace&) const = default;
};

/// Where a goal is painted on a surface, or why not and what to do. `current`: the layer that is chosen; else
/// the topmost. Values go to the topmost painted layer that changes them, else to a new one.
Result<PaintPlace> paintPlaceOf(const Surface& surface, PaintGoal goal, std::optional<int> current);

/// What lies there and can be painted; null: nothing yet.
const TexturePattern* patternAt(const Surface& surface, PaintPlace place);

/// Whether what is painted there scales a value of the material that is 0: nothing of it is felt then.
bool scalesNothing(const Surface& surface, PaintGoal goal);

/// Puts a pattern there. Makes the layer for `goal` where it is a new one.
void putPattern(Surface& surface, PaintPlace place, PaintGoal goal, const TexturePattern& pattern);

} // namespace tactum
