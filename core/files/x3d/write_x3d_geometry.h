// The triangles, lines and points of one surface as X3D geometry. For write_x3d.cpp only.
#pragma once

#include <array>
#include <vector>

#include "core/files/uv_canvas.h"
#include "core/files/x3d/xml_writer.h"
#include "core/scene/scene.h"

namespace tactum {

/// Triangles of a soup, by how many different corners they have: at 0 the points, at 1 segments, at 2
/// triangles.
using FacesByKind = std::array<std::vector<Index>, 3>;
/// One for each surface. Thread: any but real time.
std::vector<FacesByKind> facesBySurface(const SceneObject& object);

/// Writes those triangles, which have `corners` different corners each, into a Shape. Texture coordinates are
/// those of `canvas`: its rectangle is their unit square.
void writeGeometry(XmlElement& shape, const SceneObject& object, const Surface& surface, int corners,
                   const std::vector<Index>& faces, const UvCanvas& canvas);

} // namespace tactum
