#include "core/surface/painted_sample.h"

#include <algorithm>

namespace tactum {
namespace {

/// Of the function that is linear between the corners and has these values there.
Vec3 gradientOf(const Triangle& triangle, const Vec3& values, bool isSegment) noexcept {
    if (isSegment) {
        const Vec3 along = triangle.b - triangle.a;
        const double squared = along.squaredNorm();
        return squared > 0 ? Vec3((values[1] - values[0]) / squared * along) : Vec3::Zero();
    }
    const CornerUvs asCoordinates{Eigen::Vector2d(values[0], 0), Eigen::Vector2d(values[1], 0),
                                  Eigen::Vector2d(values[2], 0)};
    return uvGradientOf(triangle, asCoordinates).row(0).transpose();
}

} // namespace

TextureField samplePainted(const CompiledPattern& pattern, const TexturePoint& point) noexcept {
    const TriangleSoup& soup = *pattern.soup;
    if (point.triangle >= soup.triangles.size()) return {};
    const auto& corners = soup.triangles[point.triangle];
    Vec3 values;
    for (std::size_t k = 0; k < 3; ++k)
        values[Eigen::Index(k)] = (*pattern.painted)[corners[k]];
    const Triangle triangle{soup.positions[corners[0]], soup.positions[corners[1]],
                            soup.positions[corners[2]]};
    const Vec3 gradient = gradientOf(triangle, values, corners[1] == corners[2]);
    // Beside a triangle, where a picture continues it, too.
    const double value = std::clamp(point.weights.dot(values), 0.0, 1.0);
    return {value, gradient - gradient.dot(point.normal) * point.normal};
}

} // namespace tactum
