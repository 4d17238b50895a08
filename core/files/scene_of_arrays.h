// A mesh that a program hands over as arrays.
#pragma once

#include <string_view>

#include "core/files/load_scene.h"

namespace tactum {

/// Surfaces of such a mesh have numbers below this.
inline constexpr Index kMostArraySurfaces = 10000;

/// sceneOfMesh() with a surface for each number up to the largest in `soup.surfaceOf`, called as the object
/// where it is the only one. Every triangle has its number. Errors: input, where nothing is left that can be
/// felt; cancelled. Thread: any but real time.
Result<LoadedScene> sceneOfArrays(std::string_view name, TriangleSoup soup, const Progress& progress = {});

} // namespace tactum
