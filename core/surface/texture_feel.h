// What the texture of a surface does to the touch at one point (section 4.3).
#pragma once

#include <array>

#include "core/surface/material.h"
#include "core/surface/texture_mapping.h"
#include "core/surface/texture_stack.h"

namespace tactum {

/// Steeper slopes are cut to this: a tilted plane cannot be a wall, and beyond 45 degrees it would hold the
/// proxy rather than guide it. m/m
inline constexpr double kSteepestSlope = 1;

/// The whole texture at one point. Slopes are gradients of a height along the surface: metre per metre, body
/// frame, tangent to the surface, pointing uphill, at most kSteepestSlope long.
struct TextureFeel {
    double height = 0;         ///< m: of the blended height layers; the proxy is never lifted by it
    Vec3 slope = Vec3::Zero(); ///< of the blended height layers
    std::array<Vec3, kMaxOwnPlanes> ownSlopes{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    int ownPlanes = 0; ///< how many of ownSlopes hold: a constraint plane for each
    // Factors of the material's values, 1 where no layer changes them.
    double staticFriction = 1;
    double dynamicFriction = 1;
    double viscosity = 1;
    double stiffness = 1;
};

/// What a pattern is at a point of its plane; nothing for what is painted, which lies on none.
/// `smallestFeature` as below. Thread: real time.
FlatSample sampleFlat(const CompiledPattern& pattern, const FlatPoint& point,
                      double smallestFeature) noexcept;

/// Samples every layer. `smallestFeature`: details of the texture shorter than this length are filtered out,
/// m; kStepsToAFeature times the way of the slide in a step. 0 keeps all.
/// Anything not finite gives the plain surface. Thread: real time; at most kMaxTextureLayers patterns and
/// masks of three samples each.
TextureFeel feel(const TextureStack& stack, const TexturePoint& point, double smallestFeature) noexcept;

/// The material with the factors, inside its parameters' ranges, dynamic friction at most static.
/// Thread: real time.
Material modulated(const Material& material, const TextureFeel& feel) noexcept;

/// Blinn's tilt: the unit normal of the surface whose height has that slope over the surface of `normal`, so
/// that tangential by normal force is the slope, and pushes downhill. Thread: real time.
inline Vec3 bumpedNormal(const Vec3& normal, const Vec3& slope) noexcept {
    return (normal - slope).normalized();
}

} // namespace tactum
