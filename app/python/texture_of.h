// Layers of haptic texture made of words and arrays.
#pragma once

#include <string>

#include "app/python/pattern_of.h"

namespace tactum::python {

/// A layer of a source, with its array where that has one, a mask or None, and further properties.
TextureLayer layerOf(const std::string& source, const PatternArrays& arrays, const py::object& mask,
                     const py::kwargs& values, std::size_t vertices);

} // namespace tactum::python
