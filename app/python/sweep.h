// One parameter of a scene through many values.
#pragma once

#include <string>
#include <vector>

#include "app/python/scene_handles.h"

namespace tactum::python {

/// Copies of the scene in which `name`, a number of the scene or of these surfaces, has one value each.
/// Failure where there is no such number, or a value is out of its range.
std::vector<Scene> sweepOf(const OpenScene& of, const std::string& name, const py::handle& values,
                           const std::vector<SurfaceHandle>& surfaces);

} // namespace tactum::python
