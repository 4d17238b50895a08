// A ball whose halves are two surfaces: every answer about it is known.
#pragma once

#include <cmath>
#include <memory>

#include "core/scene/scene.h"

namespace tactum::testing {

inline constexpr double kBallRadius = 0.05; ///< m
inline constexpr Index kLower = 0, kUpper = 1;

/// A ball about the origin of meridians x rings x 2 triangles; Y is its axis.
inline std::shared_ptr<const TriangleSoup> ballSoup(Index meridians, Index rings) {
    auto soup = std::make_shared<TriangleSoup>();
    for (Index i = 0; i <= rings; ++i)
        for (Index j = 0; j < meridians; ++j) {
            const double a = EIGEN_PI * i / rings, b = 2 * EIGEN_PI * j / meridians;
            soup->positions.emplace_back(
                kBallRadius * Vec3(std::sin(a) * std::sin(b), std::cos(a), std::sin(a) * std::cos(b)));
        }
    const auto add = [&](Index a, Index b, Index c, Index surface) {
        soup->triangles.push_back({a, b, c});
        soup->surfaceOf.push_back(surface);
    };
    for (Index i = 0; i < rings; ++i)
        for (Index j = 0; j < meridians; ++j) {
            const Index a = i * meridians + j, b = i * meridians + (j + 1) % meridians;
            const Index surface = 2 * i < rings ? kUpper : kLower;
            if (i > 0) add(a, a + meridians, b, surface); // no triangles without an area at the poles
            if (i + 1 < rings) add(b, a + meridians, b + meridians, surface);
        }
    return soup;
}

inline Scene ballScene(Index meridians = 64, Index rings = 32) {
    SceneObject ball;
    ball.name = "ball";
    ball.geometry = ballSoup(meridians, rings);
    ball.surfaces.resize(2);
    ball.surfaces[kLower].name = "lower";
    ball.surfaces[kUpper].name = "upper";
    Scene scene;
    scene.add(ball);
    return scene;
}

} // namespace tactum::testing
