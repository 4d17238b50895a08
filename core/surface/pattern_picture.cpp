#include "core/surface/pattern_picture.h"

#include <algorithm>

#include "core/surface/texture_feel.h"

namespace tactum {

namespace {

constexpr double kRepeats = 2.5;   // of a pattern in its picture
constexpr double kFinestPixel = 2; // details below so many pixels are left out

/// About the origin, in the plane z = 0.
std::shared_ptr<const TriangleSoup> flatSquare(double side) {
    auto soup = std::make_shared<TriangleSoup>();
    const double h = 0.5 * side;
    soup->positions = {{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}};
    soup->triangles = {{0, 1, 2}, {0, 2, 3}};
    soup->surfaceOf = {0, 0};
    return soup;
}

/// The longer side of an image fills the square.
double sideOf(const TexturePattern& pattern) {
    const double size = kTextureSize.clamped(pattern.size);
    if (pattern.source != TextureSource::Image) return kRepeats * size;
    return size * std::max(1.0, double(pattern.image->height()) / pattern.image->width());
}

} // namespace

PatternPicture patternOnFlatGround(const TexturePattern& pattern, int pixels) {
    if (pattern.source == TextureSource::Painted) return {};
    if (pattern.source == TextureSource::Image && !pattern.image) return {};
    PatternPicture picture{pixels, sideOf(pattern), {}};
    TextureLayer layer;
    layer.strength = kTextureHeight.maximum;
    layer.pattern = pattern;
    layer.pattern.mapping = TextureMapping::Planar;
    layer.pattern.frame = {};
    if (pattern.source == TextureSource::Image)
        layer.pattern.offsetU = layer.pattern.offsetV = -0.5 * picture.side;
    const auto stack = compileTextures({layer}, flatSquare(picture.side), 0);
    if (!stack) return {};
    const double pixel = picture.side / pixels;
    for (int row = 0; row < pixels; ++row)
        for (int column = 0; column < pixels; ++column) {
            TexturePoint point;
            point.position = {(column + 0.5) * pixel - 0.5 * picture.side,
                              0.5 * picture.side - (row + 0.5) * pixel, 0};
            picture.values.push_back(feel(*stack, point, kFinestPixel * pixel).height / layer.strength);
        }
    return picture;
}

} // namespace tactum
