// The round brush of an author: its numbers, and how its effect falls off from the middle.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/surface/texture_layer.h"

namespace tactum {

inline constexpr Parameter kBrushRadius{
    "brush-radius", "Radius", "m",
    1e-4,           0.2,      5e-4,
    5e-3,           4,        "How far from its middle the brush paints, measured straight through space."};
inline constexpr Parameter kBrushStrength{
    "brush-strength",
    "Strength",
    "",
    0,
    1,
    0.05,
    0.5,
    2,
    "How much one stroke changes in the middle of the brush, however often it crosses itself."};
inline constexpr Parameter kBrushFalloff{"brush-falloff",
                                         "Falloff",
                                         "",
                                         0,
                                         1,
                                         0.05,
                                         0.7,
                                         2,
                                         "Part of the radius over which the effect fades to nothing: 0 is a "
                                         "hard edge, at 1 it fades from the middle."};
inline constexpr Parameter kBrushValue{
    "brush-value", "Value", "", 0, 1, 0.05, 1, 2, "What the mode \"set\" paints toward."};

enum class BrushMode : std::uint8_t { Add, Subtract, Set, Smooth };
inline constexpr std::array<NamedChoice, 4> kBrushModes{
    {{"add", "Add"}, {"subtract", "Subtract"}, {"set", "Set"}, {"smooth", "Smooth"}}};

struct Brush {
    double radius = kBrushRadius.initial;     ///< m
    double strength = kBrushStrength.initial; ///< 0 to 1
    double falloff = kBrushFalloff.initial;   ///< 0 hard to 1 smooth
    double value = kBrushValue.initial;       ///< of the mode Set
    BrushMode mode = BrushMode::Add;

    bool operator==(const Brush&) const = default;
};

struct BrushField {
    const Parameter* parameter;
    double Brush::*value;
};

/// Every number of a brush, in the order in which a person reads them.
inline constexpr std::array<BrushField, 4> kBrushFields{{
    {&kBrushRadius, &Brush::radius},
    {&kBrushStrength, &Brush::strength},
    {&kBrushFalloff, &Brush::falloff},
    {&kBrushValue, &Brush::value},
}};

/// With every number in its range.
inline Brush madeSafe(Brush brush) {
    for (const BrushField& field : kBrushFields)
        brush.*field.value = field.parameter->clamped(brush.*field.value);
    return brush;
}

/// How much counts at the distance x of the middle, x as a part of the radius. With f the falloff: 1 up to
/// 1 - f, from there s^2 (3 - 2 s) with s = (1 - x) / f, and 0 beyond 1. Of f = 0 the edge itself counts
/// whole.
inline double falloffAt(double x, double falloff) {
    if (!(x <= 1)) return 0;
    if (x <= 1 - falloff) return 1;
    const double s = std::clamp((1 - x) / falloff, 0.0, 1.0);
    return s * s * (3 - 2 * s);
}

/// What a stroke makes of a value: `weight` is the greatest falloff of its dabs there. Of the mode Smooth,
/// what a dab makes of it with `mean` around it.
inline double painted(const Brush& brush, double before, double weight, double mean = 0) {
    const double part = brush.strength * weight;
    switch (brush.mode) {
    case BrushMode::Add:
        return std::min(before + part, 1.0);
    case BrushMode::Subtract:
        return std::max(before - part, 0.0);
    case BrushMode::Set:
        return before + part * (brush.value - before);
    case BrushMode::Smooth:
        return before + part * (mean - before);
    }
    return before;
}

} // namespace tactum
