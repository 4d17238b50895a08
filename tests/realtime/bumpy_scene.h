// A rough plate to slide on: many contacts, pits and edges, friction and slip.
#pragma once

#include <memory>

#include "core/scene/scene.h"

namespace tactum {

inline constexpr double kBumpyHalfWidth = 0.05; ///< m, in x and y
inline constexpr double kBumpHeight = 2e-3;     ///< m, the surface lies within this of z = 0

/// A field of random bumps over the plane z = 0. The same seed gives the same soup.
std::shared_ptr<const TriangleSoup> bumpyPlate(unsigned seed);

/// The plate with one of many materials: stiffness, damping, all three frictions, shading and texture vary
/// with `edit`. A second
/// one moves by itself above it, onto the finger and through it.
Scene bumpyScene(const std::shared_ptr<const TriangleSoup>& plate, int edit);

/// A finger that wanders over the plate at up to 0.15 m/s and dips in and out of it. t in s.
Vec3 wanderingFinger(double t);

} // namespace tactum
