// Simple bodies of a hand's size: closed meshes with normals and texture coordinates, for an author to begin
// with.
#pragma once

#include <array>
#include <string_view>

#include "core/scene/scene.h"

namespace tactum {

/// A cube of 60 mm, a ball and a cylinder of 60 mm across, a plate of 120 mm, and a floor of 320 mm to put
/// things on. Each about the origin, y up; what is round is shaded, so that no facet is felt. Its texture
/// coordinates lay one square over each side, over the whole ball, and around the cylinder.
enum class Primitive : std::uint8_t { Box, Sphere, Cylinder, Plate, Ground };

/// One object of one surface. Thread: any but real time.
Scene sceneOf(Primitive primitive);

} // namespace tactum
