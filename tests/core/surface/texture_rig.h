// Layers, images and surfaces from formulas, and slopes by finite differences.
#pragma once

#include <memory>
#include <vector>

#include "core/surface/texture_feel.h"
#include "tests/support/soups.h"

namespace tactum::test {

using Image = std::shared_ptr<const TextureImage>;
using Stack = std::shared_ptr<const TextureStack>;
using Eigen::Vector2d;

/// value(x, y) from 0 to 1 at the centre of each texel, x and y in repeats.
template <class Value> Image imageOf(int width, int height, Value&& value, int bits = 16) {
    std::vector<std::uint16_t> texels;
    const double most = bits == 8 ? 255 : 65535;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            texels.push_back(std::uint16_t(65535 / most *
                                           std::round(most * value((x + 0.5) / width, (y + 0.5) / height))));
    return std::make_shared<const TextureImage>(width, height, std::move(texels), "formula", bits);
}

/// Rises along x from 0 to 1 over the whole repeat.
inline Image ramp(int width = 256, int bits = 16) {
    return imageOf(
        width, 4, [](double x, double) { return x; }, bits);
}

/// A triangle with texture coordinates on its corners.
struct UvTriangle {
    Triangle triangle;
    CornerUvs uvs;

    TexturePoint at(const Vec3& weights) const {
        TexturePoint point;
        point.position = weights[0] * triangle.a + weights[1] * triangle.b + weights[2] * triangle.c;
        point.normal = (triangle.b - triangle.a).cross(triangle.c - triangle.a).normalized();
        point.uv = weights[0] * uvs[0] + weights[1] * uvs[1] + weights[2] * uvs[2];
        point.uvGradient = uvGradientOf(triangle, uvs);
        return point;
    }
    Soup soup() const {
        auto result = std::make_shared<TriangleSoup>();
        result->positions = {triangle.a, triangle.b, triangle.c};
        result->triangles = {{0, 1, 2}};
        result->surfaceOf = {0};
        for (const Vector2d& uv : uvs)
            result->cornerUvs.push_back(uv.cast<float>());
        return result;
    }
};

/// A square in the plane z = 0 with a corner at the origin, whose coordinates run from `low` to `high`.
inline TriangleSoup uvSquare(double side, const Vector2d& low = {0, 0}, const Vector2d& high = {1, 1}) {
    TriangleSoup soup;
    std::vector<Eigen::Vector2f> uvs;
    for (const Vector2d& at : {Vector2d(0, 0), Vector2d(1, 0), Vector2d(1, 1), Vector2d(0, 1)}) {
        soup.positions.emplace_back(side * at.x(), side * at.y(), 0);
        uvs.push_back(Vector2d(low + (high - low).cwiseProduct(at)).cast<float>());
    }
    soup.triangles = {{0, 1, 2}, {0, 2, 3}};
    soup.surfaceOf = {0, 0};
    for (const auto& t : soup.triangles)
        for (const Index i : t)
            soup.cornerUvs.push_back(uvs[i]);
    return soup;
}

/// A layer of height that nothing else changes.
inline TextureLayer heightLayer(TextureSource source, TextureMapping mapping, double size, double height) {
    TextureLayer layer;
    layer.pattern.source = source;
    layer.pattern.mapping = mapping;
    layer.pattern.size = size;
    layer.strength = height;
    return layer;
}

inline TextureLayer imageLayer(Image image, TextureMapping mapping, double size, double height) {
    TextureLayer layer = heightLayer(TextureSource::Image, mapping, size, height);
    layer.pattern.image = std::move(image);
    return layer;
}

inline Stack stackOf(std::vector<TextureLayer> layers, Soup soup = std::make_shared<TriangleSoup>()) {
    return compileTextures(layers, soup, 0);
}

/// The place a little way along the surface, on the same flat piece of it.
inline TexturePoint moved(TexturePoint point, const Vec3& way) {
    point.position += way;
    point.uv += point.uvGradient * way;
    return point;
}

/// The slope of the blended height by central differences along two tangents.
inline Vec3 measuredSlope(const TextureStack& stack, const TexturePoint& point, double smallestFeature,
                          double step) {
    const Vec3 t = point.normal.unitOrthogonal(), b = point.normal.cross(t);
    Vec3 slope = Vec3::Zero();
    for (const Vec3& way : {t, b}) {
        const double up = feel(stack, moved(point, step * way), smallestFeature).height,
                     down = feel(stack, moved(point, -step * way), smallestFeature).height;
        slope += (up - down) / (2 * step) * way;
    }
    return slope;
}

/// Root mean square of the slope over a patch of the plane z = 0, at `count` random places.
inline double meanSlope(const TextureStack& stack, double smallestFeature, double half, int count = 2000) {
    Rng rng(5);
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        TexturePoint point;
        point.position = {uniform(rng, -half, half), uniform(rng, -half, half), 0};
        sum += feel(stack, point, smallestFeature).slope.squaredNorm();
    }
    return std::sqrt(sum / count);
}

} // namespace tactum::test
