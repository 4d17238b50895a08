// How far one object of a scene reaches.
#pragma once

#include "core/scene/scene.h"

namespace tactum {

/// The box of an object in the world frame, at the time 0. Some 15 ms for a million triangles.
Bounds boundsOf(const SceneObject& object);

} // namespace tactum
