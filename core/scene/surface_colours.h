// Colours by which the surfaces of an object are told apart where nobody chose any.
#pragma once

#include <span>
#include <vector>

#include "core/scene/scene.h"
#include "core/scene/surface_ref.h"

namespace tactum {

/// The colour of a small palette that is least like those of the surfaces: linear RGB, 0 to 1. The first of
/// the palette where there are none. Thread: any but real time.
Eigen::Vector3f colourApartFrom(std::span<const Surface> surfaces);

/// All surfaces of the scene that look alike: whose colour differs by no step of a screen. Itself is among
/// them; none for a reference to nothing. Thread: any but real time.
std::vector<SurfaceRef> surfacesColouredLike(const Scene& scene, SurfaceRef ref);

/// Whether somebody has said how its surfaces look: not all of them have the colour of a Surface. Thread: any
/// but real time.
bool isColoured(const SceneObject& object);

/// Gives each surface a colour of its own in objects that have several and are not coloured. Others stay as
/// they are: their file has said something. Thread: any but real time.
void tellSurfacesApart(Scene& scene);

} // namespace tactum
