// Patterns of haptic texture, of a layer and of its mask, made of words and arrays.
#pragma once

#include <string>

#include "app/python/scene_handles.h"

namespace tactum::python {

/// Where the values of a pattern come from: each None where its source is another one.
struct PatternArrays {
    py::object image, paint;
};

/// Gives a pattern a source. `vertices`: of the mesh that it lies on. Failure where the arrays are not those
/// that the source wants.
void setSource(TexturePattern& pattern, const std::string& source, const PatternArrays& arrays,
               std::size_t vertices);
/// A mask out of (rows, columns) or (n,) values, which lies as its layer does, or out of the name of a
/// source.
TexturePattern maskOf(const py::handle& values, const TexturePattern& layer, std::size_t vertices);

/// None where nothing is painted.
py::object arrayOfPaint(const TexturePattern& of, std::size_t vertices);
/// Failure where nothing is painted, or for other than one number for each vertex.
void setPaint(TexturePattern& of, const py::handle& values, std::size_t vertices);

/// `paint` of what holds a pattern: `patternOf(handle)` is that, and `layer(handle)` the layer it is of.
template <class Handle, class PatternOf, class LayerOf>
void declarePaint(py::class_<Handle>& to, PatternOf patternOf, LayerOf layerOf) {
    to.def_property(
        "paint", [=](const Handle& of) { return arrayOfPaint(patternOf(of), layerOf(of).vertices()); },
        [=](const Handle& of, const ArrayLike& values) {
            setPaint(patternOf(of), values, layerOf(of).vertices());
        },
        "Optional[numpy.typing.NDArray[numpy.float64]]: A copy of what is painted, (n,) values from 0 to 1, "
        "one for each of the object's vertices, linear in between; None for another source. Setting it "
        "paints anew; an Error for another source or another number of values.");
}

} // namespace tactum::python
