// Where the frame of a texture's mapping goes on a surface that has none yet.
#pragma once

#include "core/geometry/triangle_soup.h"
#include "core/surface/texture_layer.h"

namespace tactum {

/// The pattern with its frame in the middle of a surface: a plane looks along the surface's mean normal, a
/// cylinder and a sphere stand upright about it, with a radius as large as the surface is on average. Others
/// stay as they are, and so does everything for a surface without triangles. Some 10 ms for a million
/// triangles. Thread: any but real time.
TexturePattern fitted(TexturePattern pattern, const TriangleSoup& soup, Index surface);

} // namespace tactum
