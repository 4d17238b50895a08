// Meshes made of arrays.
#pragma once

#include <string>

#include "app/python/scene_handles.h"

namespace tactum::python {

/// A new object of the scene, repaired where it has to be. Failure for arrays that are no mesh.
ObjectHandle addMesh(const SceneHold& to, const ArrayLike& vertices, const ArrayLike& triangles,
                     const py::object& surfaces, const std::string& name);

} // namespace tactum::python
