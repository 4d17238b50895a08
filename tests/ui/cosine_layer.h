// A layer of texture that anybody can write down: grooves that are a cosine.
#pragma once

#include <cmath>
#include <numbers>

#include "core/surface/texture_layer.h"

namespace tactum::test {

/// Half up, half down, with the softest edges.
inline TextureLayer cosineLayer(TextureTarget target, double strength, double period) {
    TextureLayer layer;
    layer.name = "Grooves";
    layer.pattern.source = TextureSource::Grooves;
    layer.pattern.size = period;
    layer.pattern.fill = 0.5;
    layer.pattern.softness = 1;
    layer.target = target;
    layer.strength = strength;
    return layer;
}

/// Its value, from 0 to 1: 1 in the middle of a ridge, which is at 0.
inline double cosineAt(double x, double period) {
    return (1 + std::cos(2 * std::numbers::pi * x / period)) / 2;
}

} // namespace tactum::test
