// Layers of haptic texture made of words and arrays.
#pragma once

#include <string>

#include "app/python/scene_handles.h"

namespace tactum::python {

/// A layer of a source, with an image where that is one, and with further properties.
TextureLayer layerOf(const std::string& source, const py::object& image, const py::kwargs& values);

} // namespace tactum::python
