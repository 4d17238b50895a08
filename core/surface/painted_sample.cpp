#include "core/surface/painted_sample.h"

#include <algorithm>
#include <array>

#include "core/surface/clough_tocher.h"
#include "core/surface/painted_slopes.h"
#include "core/surface/unrolled_place.h"

namespace tactum {
namespace {

/// And on a sliver without a plane, which has no slope.
Rise onSegment(const Triangle& triangle, const Vec3& values, const Vec3& weights, bool isSegment) noexcept {
    const Vec3 along = triangle.b - triangle.a;
    const double squared = along.squaredNorm();
    return {weights.dot(values),
            isSegment && squared > 0 ? Vec3((values[1] - values[0]) / squared * along) : Vec3::Zero()};
}

Vec3 valuesAt(const CompiledPattern& pattern, Index triangle) noexcept {
    const auto& corners = pattern.soup->triangles[triangle];
    return {(*pattern.painted)[corners[0]], (*pattern.painted)[corners[1]], (*pattern.painted)[corners[2]]};
}

/// No weight below zero.
Rise onTriangle(const CompiledPattern& pattern, Index index, const Triangle& triangle,
                const Vec3& weights) noexcept {
    const Vec3 values = valuesAt(pattern, index);
    const std::array<Vec3, 3> slopes = paintedSlopes(pattern, index);
    const Rise rise = CloughTocher(triangle, values, slopes, pattern.slopes->bulge(index)).at(weights);
    return rise.slope.allFinite() ? rise : Rise{weights.dot(values), linearSlope(triangle, values)};
}

/// Beside a triangle, too, where the surface goes on, and straight on where it ends.
Rise onSurface(const CompiledPattern& pattern, const TexturePoint& point) noexcept {
    const UnrolledPlace place(*pattern.soup, *pattern.slopes->ground(), point.triangle, point.weights);
    const Vec3 inside = place.weights().cwiseMax(0) / place.weights().cwiseMax(0).sum(),
               beside = place.weights() - inside;
    const Triangle& t = place.corners();
    Rise rise = onTriangle(pattern, place.triangle(), t, inside);
    rise.value += rise.slope.dot(beside[0] * t.a + beside[1] * t.b + beside[2] * t.c);
    rise.slope = place.turnedBack(rise.slope);
    return rise;
}

/// Beside a hard edge the cubic would leave 0 to 1: more and more slowly, so that the slope does not jump.
Rise keptNearRange(const Rise& rise) noexcept {
    constexpr double kFarthest = 0.01;
    const double end = std::clamp(rise.value, 0.0, 1.0), beyond = rise.value - end,
                 slower = 1 / (1 + std::abs(beyond) / kFarthest);
    return {end + slower * beyond, slower * slower * rise.slope};
}

} // namespace

std::array<Vec3, 3> paintedSlopes(const CompiledPattern& pattern, Index triangle) noexcept {
    const Triangle t = cornersOf(*pattern.soup, triangle);
    const Vec3 flat = linearSlope(t, valuesAt(pattern, triangle));
    const Vec3 normal = (t.b - t.a).cross(t.c - t.a).normalized();
    std::array<Vec3, 3> slopes;
    for (std::size_t k = 0; k < 3; ++k)
        slopes[k] = pattern.slopes->at(pattern.soup->triangles[triangle][k], normal, flat);
    return slopes;
}

TextureField samplePainted(const CompiledPattern& pattern, const TexturePoint& point) noexcept {
    if (point.triangle >= pattern.soup->triangles.size()) return {};
    const auto& corners = pattern.soup->triangles[point.triangle];
    const Triangle triangle = cornersOf(*pattern.soup, point.triangle);
    const bool hasPlane = (triangle.b - triangle.a).cross(triangle.c - triangle.a).squaredNorm() > 0;
    const Rise rise = hasPlane ? onSurface(pattern, point)
                               : onSegment(triangle, valuesAt(pattern, point.triangle), point.weights,
                                           corners[1] == corners[2]);
    const Rise kept = keptNearRange(rise);
    return {kept.value, kept.slope - kept.slope.dot(point.normal) * point.normal};
}

} // namespace tactum
