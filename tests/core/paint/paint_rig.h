// Meshes to paint on, and strokes over them.
#pragma once

#include "core/paint/image_stroke.h"
#include "core/paint/vertex_stroke.h"
#include "tests/support/soups.h"

namespace tactum::test {

inline std::shared_ptr<const SoupReach> reachOf(Soup soup) {
    return std::make_shared<const SoupReach>(std::move(soup));
}

inline Brush brushOf(BrushMode mode, double radius, double strength, double falloff, double value = 1) {
    return {radius, strength, falloff, value, mode};
}

inline std::vector<float> onVertices(const Soup& soup, const Brush& brush, const std::vector<Dab>& places,
                                     std::vector<float> before = {}, PaintableSurfaces surfaces = {}) {
    VertexStroke stroke(reachOf(soup), std::move(surfaces),
                        std::make_shared<const PaintedValues>(std::move(before)), brush);
    for (const Dab& place : places)
        stroke.moveTo(place);
    return stroke.now();
}

/// The closed form that brush.h says, written down again.
inline double expectedFalloff(double x, double falloff) {
    if (x > 1) return 0;
    if (x <= 1 - falloff) return 1;
    const double s = (1 - x) / falloff;
    return 3 * s * s - 2 * s * s * s;
}

/// Distance from a path of straight pieces.
inline double distanceTo(const std::vector<Vec3>& path, const Vec3& p) {
    double least = (p - path.front()).norm();
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const Vec3 way = path[i + 1] - path[i];
        const double part = std::clamp((p - path[i]).dot(way) / way.squaredNorm(), 0.0, 1.0);
        least = std::min(least, (p - path[i] - part * way).norm());
    }
    return least;
}

} // namespace tactum::test
