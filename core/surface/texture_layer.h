// The layers of haptic texture that an author lays on a surface (section 4.3): plain values.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/vec.h"
#include "core/surface/painted_values.h"
#include "core/surface/texture_image.h"
#include "core/surface/texture_parameters.h"

namespace tactum {

/// Where the values from 0 to 1 come from.
enum class TextureSource : std::uint8_t { Image, Noise, Grooves, Dots, Weave, Painted };

/// How the flat pattern comes onto the surface. All but the first two need no texture coordinates. What is
/// painted is on the surface already and needs none of them.
enum class TextureMapping : std::uint8_t {
    Uv,          ///< the mesh's coordinates, scaled as a whole so that lengths are metres on average
    UvUnit,      ///< the mesh's coordinates as they are: one repeat fills the unit square
    Triplanar,   ///< along the three axes of the frame, blended by the normal
    Planar,      ///< along z of the frame onto its x and y
    Cylindrical, ///< around z of the frame; a whole number of repeats fills a turn
    Spherical    ///< longitude and latitude about z of the frame
};

/// How a layer joins what lies below it.
enum class TextureBlend : std::uint8_t { Add, Subtract, Multiply, Maximum, Minimum, Replace };

/// What a layer changes. Height tilts the constraint planes; the others scale a value of the material.
enum class TextureTarget : std::uint8_t { Height, StaticFriction, DynamicFriction, Viscosity, Stiffness };

/// A key for files and a label for the screen, in the order of the enumerators.
struct NamedChoice {
    std::string_view key, label;
};
inline constexpr std::array<NamedChoice, 6> kTextureSources{{{"image", "Image"},
                                                             {"noise", "Noise"},
                                                             {"grooves", "Grooves"},
                                                             {"dots", "Dots"},
                                                             {"weave", "Weave"},
                                                             {"painted", "Painted"}}};
inline constexpr std::array<NamedChoice, 6> kTextureMappings{{{"uv", "UV, in metres"},
                                                              {"uv-unit", "UV, unit square"},
                                                              {"triplanar", "Triplanar"},
                                                              {"planar", "Planar"},
                                                              {"cylindrical", "Cylindrical"},
                                                              {"spherical", "Spherical"}}};
inline constexpr std::array<NamedChoice, 6> kTextureBlends{{{"add", "Add"},
                                                            {"subtract", "Subtract"},
                                                            {"multiply", "Multiply"},
                                                            {"maximum", "Lighten (maximum)"},
                                                            {"minimum", "Darken (minimum)"},
                                                            {"replace", "Normal (replace)"}}};
inline constexpr std::array<NamedChoice, 5> kTextureTargets{{{"height", "Height"},
                                                             {"static-friction", "Static friction"},
                                                             {"dynamic-friction", "Dynamic friction"},
                                                             {"viscosity", "Viscosity"},
                                                             {"stiffness", "Stiffness"}}};

/// A field of values from 0 to 1 over the surface.
struct TexturePattern {
    TextureSource source = TextureSource::Noise;
    std::shared_ptr<const TextureImage> image; ///< of the source Image
    SharedPaint painted;                       ///< of the source Painted
    TextureMapping mapping = TextureMapping::Triplanar;
    double size = kTextureSize.initial;         ///< m: width of a repeat; its height follows the image
    double offsetU = kTextureOffsetU.initial;   ///< m
    double offsetV = kTextureOffsetV.initial;   ///< m
    double rotation = kTextureRotation.initial; ///< rad, counter-clockwise
    Pose frame;                                 ///< X_BM: of the mappings without UVs, in the body
    double radius = kTextureRadius.initial;     ///< m: of Cylindrical and Spherical, where size is true
    double fill = kTextureFill.initial;         ///< Grooves and Dots: the raised part of a repeat
    double softness = kTextureSoftness.initial; ///< Grooves and Dots: width of an edge, part of a repeat
    double octaves = kTextureOctaves.initial;   ///< Noise: how many, each twice as fine and half as high
    double seed = kTextureSeed.initial;         ///< Noise: which one

    bool operator==(const TexturePattern&) const = default;
};

/// Whether it lies on the mesh's texture coordinates.
inline bool usesUvs(const TexturePattern& pattern) {
    return pattern.source != TextureSource::Painted &&
           (pattern.mapping == TextureMapping::Uv || pattern.mapping == TextureMapping::UvUnit);
}

/// One layer. Its amount is strength x value; opacity x mask says how much of the layer counts.
///
/// Height begins at 0 m below the first layer and a layer's amount is a height. A modulation begins at the
/// factor 1 and a layer's amount is 1 + strength x value. With w = opacity x mask, H what lies below and L
/// the amount (Add and Subtract of a modulation take strength x value alone): Add H + w L, Subtract H - w L,
/// Maximum and Minimum of H and L, Replace L, the last three mixed with H by w; Multiply scales H by the
/// value (height) or by L (modulation), mixed with 1 by w.
struct TextureLayer {
    std::string name;
    bool enabled = true;
    TexturePattern pattern;
    TextureTarget target = TextureTarget::Height;
    double strength = kTextureHeight.initial; ///< m for Height, else ratio: see strengthParameter()
    TextureBlend blend = TextureBlend::Add;
    double opacity = kTextureOpacity.initial; ///< ratio
    std::optional<TexturePattern> mask;       ///< multiplies opacity
    /// Height only: a constraint plane for this layer alone, as in section 4.3; it joins no blend.
    bool ownPlane = false;

    bool operator==(const TextureLayer&) const = default;
};

/// Unit and range of a layer's strength.
inline const Parameter& strengthParameter(TextureTarget target) {
    return target == TextureTarget::Height ? kTextureHeight : kTextureRatio;
}

struct PatternField {
    const Parameter* parameter;
    double TexturePattern::*value;
};

/// Every number of a pattern, in the order in which a person reads them.
inline constexpr std::array<PatternField, 9> kPatternFields{{
    {&kTextureSize, &TexturePattern::size},
    {&kTextureOffsetU, &TexturePattern::offsetU},
    {&kTextureOffsetV, &TexturePattern::offsetV},
    {&kTextureRotation, &TexturePattern::rotation},
    {&kTextureRadius, &TexturePattern::radius},
    {&kTextureFill, &TexturePattern::fill},
    {&kTextureSoftness, &TexturePattern::softness},
    {&kTextureOctaves, &TexturePattern::octaves},
    {&kTextureSeed, &TexturePattern::seed},
}};

/// More layers of one surface are not felt: what a step costs stays bounded.
inline constexpr int kMaxTextureLayers = 16;
/// More layers with a plane of their own join the blend instead.
inline constexpr int kMaxOwnPlanes = 4;

} // namespace tactum
