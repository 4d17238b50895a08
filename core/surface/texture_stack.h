// What compiling makes of a surface's texture layers: ready to be sampled, immutable, shared.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry/triangle_soup.h"
#include "core/surface/painted_slopes.h"
#include "core/surface/procedural_texture.h"
#include "core/surface/texture_layer.h"

namespace tactum {

/// A pattern with everything worked out that does not depend on the place. Values are inside their ranges.
struct CompiledPattern {
    TextureSource source = TextureSource::Noise;
    TextureMapping mapping = TextureMapping::Triplanar;
    std::shared_ptr<const TextureImage> image; ///< never empty for the source Image
    /// Never empty for the source Painted: as many values as the soup has positions.
    std::shared_ptr<const PaintedValues> painted;
    std::shared_ptr<const TriangleSoup> soup;    ///< of the source Painted
    std::shared_ptr<const PaintedSlopes> slopes; ///< of the source Painted: never empty there
    double metresPerUv = 0;                      ///< of one unit of the mesh's coordinates
    Mat3 axes = Mat3::Identity();                ///< rows: the axes of the mapping frame, in the body frame
    Vec3 origin = Vec3::Zero();                  ///< of the mapping frame, body frame, m
    double radius = 1;                           ///< m
    double metresPerRadian = 1;                  ///< around the axis; a turn is a whole number of repeats
    Eigen::Vector2d offset = Eigen::Vector2d::Zero();              ///< m
    Eigen::Matrix2d repeatsPerMetre = Eigen::Matrix2d::Identity(); ///< turns and scales
    WaveShape wave;
    int octaves = 1;
    std::uint32_t seed = 0;
};

/// Whether it lies on the mesh's texture coordinates. Thread: real time.
inline bool usesUvs(const CompiledPattern& pattern) noexcept {
    return pattern.source != TextureSource::Painted &&
           (pattern.mapping == TextureMapping::Uv || pattern.mapping == TextureMapping::UvUnit);
}

struct CompiledLayer {
    CompiledPattern pattern;
    std::optional<CompiledPattern> mask;
    TextureTarget target = TextureTarget::Height;
    TextureBlend blend = TextureBlend::Add;
    double strength = 0; ///< m or ratio
    double opacity = 1;
    bool ownPlane = false; ///< of at most kMaxOwnPlanes layers
};

/// The layers of one surface of one mesh that can be felt, lowest first, at most kMaxTextureLayers.
struct TextureStack {
    std::vector<CompiledLayer> layers;
    bool asksForTurning = false; ///< some pattern is triplanar: it changes with the normal

    // What it was made of: to know whether it can be used again.
    std::vector<TextureLayer> source;
    std::shared_ptr<const TriangleSoup> soup;
    Index surface = 0;
    double metresPerUv = -1; ///< negative where no layer asked for it
};

/// The stack of one surface. Layers that are off, lack their image, have painted values that are not one for
/// each position of the mesh, or ask for UVs that it has not are left out (validation tells the person);
/// nothing is returned when none is left. A stack among `known` that was made of the same is returned itself;
/// images bring their levels along, so a new stack costs no more than its numbers, and a look at the mesh
/// where the UVs' scale or the slopes of what is painted are needed and not known. Thread: any but real time.
std::shared_ptr<const TextureStack>
compileTextures(const std::vector<TextureLayer>& layers, const std::shared_ptr<const TriangleSoup>& soup,
                Index surface, std::span<const std::shared_ptr<const TextureStack>> known = {});

/// Whether compileTextures() would have to make slopes of what is painted, for all of the mesh: the stacks in
/// `known` are of other values. Thread: any but real time.
bool arePaintedAnew(const std::vector<TextureLayer>& layers, const TriangleSoup& soup, Index surface,
                    std::span<const std::shared_ptr<const TextureStack>> known);

/// How long one unit of the mesh's texture coordinates is on a surface, on average over its area: the square
/// root of area by area. m; 0 without usable coordinates. Thread: any but real time.
double metresPerUvOf(const TriangleSoup& soup, Index surface);

} // namespace tactum
