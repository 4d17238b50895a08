// A whole scene made larger, or set upright: for files that have no unit or another axis that points up.
#pragma once

#include "core/scene/scene.h"

namespace tactum {

/// Scales every object, what moves, and the finger that shows the scene, about a point that becomes the
/// origin.
void scaleScene(Scene& scene, double factor, const Vec3& about);

/// From z up to y up: x stays, z becomes y. Not for a scene of bodies, which have their own gravity: returns
/// false and leaves it as it is.
bool turnUpright(Scene& scene);

} // namespace tactum
