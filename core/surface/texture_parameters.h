// The numbers of a texture layer, each said once.
#pragma once

#include "core/surface/parameter.h"

namespace tactum {

inline constexpr Parameter kTextureSize{
    "size",
    "Size",
    "m",
    1e-4,
    10,
    1e-3,
    0.01,
    4,
    "Width of one repeat on the surface; for noise, of its coarsest grain. The height of an image follows "
    "from its proportions."};
inline constexpr Parameter kTextureOffsetU{
    "offset-u", "Offset u", "m", -10, 10, 1e-3, 0, 4, "How far the pattern is moved along its rows."};
inline constexpr Parameter kTextureOffsetV{
    "offset-v", "Offset v", "m", -10, 10, 1e-3, 0, 4, "How far the pattern is moved across its rows."};
inline constexpr Parameter kTextureRotation{
    "rotation",
    "Rotation",
    "rad",
    -6.283185307179586,
    6.283185307179586,
    0.08726646259971647,
    0,
    3,
    "How far the pattern is turned on the surface, counter-clockwise."};
inline constexpr Parameter kTextureRadius{
    "mapping-radius",
    "Mapping radius",
    "m",
    1e-4,
    10,
    1e-3,
    0.05,
    4,
    "Radius of the cylinder or sphere on which the size of the pattern is true."};
inline constexpr Parameter kTextureFill{
    "fill", "Fill", "",
    0.05,   0.95,   0.05,
    0.5,    2,      "How much of a repeat is raised, between grooves or as a dot."};
inline constexpr Parameter kTextureSoftness{
    "softness", "Softness", "",
    0.1,        1,          0.05,
    0.4,        2,          "Width of the edge between low and high as a part of a repeat."};
inline constexpr Parameter kTextureOctaves{
    "octaves", "Octaves", "",
    1,         8,         1,
    4,         0,         "Layers of noise, each twice as fine and half as high as the one before."};
inline constexpr Parameter kTextureSeed{
    "seed", "Seed", "", 0, 9999, 1, 0, 0, "Another number gives another noise of the same kind."};
inline constexpr Parameter kTextureHeight{
    "height",
    "Height",
    "m",
    -0.01,
    0.01,
    1e-5,
    2e-4,
    5,
    "Height of the pattern's highest places above its lowest; negative turns bumps into dents. The surface "
    "is tilted by it, never lifted (section 4.3)."};
inline constexpr Parameter kTextureRatio{
    "ratio",
    "Ratio",
    "",
    -1,
    10,
    0.05,
    0.5,
    2,
    "What the pattern's highest places add to the value of the material, as a part of it; -1 takes it away."};
inline constexpr Parameter kTextureOpacity{
    "opacity", "Opacity", "", 0, 1, 0.05, 1, 2, "How much of the layer counts."};

} // namespace tactum
