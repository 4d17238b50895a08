// What was felt along a path, as tactum.Touch: the same type that the server's replay gives.
#pragma once

#include <span>
#include <vector>

#include "app/python/arrays.h"
#include "core/haptics/replay.h"

namespace tactum::python {

/// A tactum.Touch. Its name in signatures says so.
struct TouchObject : py::object {
    PYBIND11_OBJECT_DEFAULT(TouchObject, py::object, isAnything)
};

TouchObject touchOf(const TouchTrace& rows);
/// Several over the same path, with an axis more in front.
TouchObject touchOf(std::span<const TouchTrace> traces);

} // namespace tactum::python

namespace pybind11::detail {
template <> struct handle_type_name<tactum::python::TouchObject> {
    static constexpr auto name = const_name("tactum.results.Touch");
};
} // namespace pybind11::detail
