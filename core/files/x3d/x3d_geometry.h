// The geometry nodes of X3D as polygons. For the X3D reader only.
#pragma once

#include "core/files/world_mesh.h"
#include "core/files/x3d/x3d_document.h"

namespace tactum {

/// Adds the polygons of a geometry node; false for a kind of node that is not read. Throws ReadFault where an
/// index leads to nothing.
/// `welded`: vertices at one place are one.
bool addGeometry(const X3dDocument& document, X3dNode geometry, WorldMesh& mesh, Index surface,
                 bool welded = false);

} // namespace tactum
