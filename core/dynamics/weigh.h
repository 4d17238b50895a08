// What a body weighs, from the shapes that it is made of.
#pragma once

#include "core/dynamics/collider.h"

namespace tactum {

/// Of a body whose mass nobody says: water, kg/m^3.
inline constexpr double kDensity = 1000;

/// Centre and moments of a body of `mass` kg whose shapes are `shapes` together, of even density. Of shapes
/// that enclose nothing: of a ball of water about the body's origin. Mass 0 counts as 1 for the moments.
/// Thread: any but real time.
void weigh(RigidBody& body, const ShapeMass& shapes, double mass);

} // namespace tactum
