// Presets by themselves, by the names of those that are installed, or as files.
#pragma once

#include "app/python/scene_handles.h"
#include "core/presets/preset.h"

namespace tactum::python {

/// A Preset, a name or a file. Its name in signatures says so.
struct PresetLike : py::object {
    PYBIND11_OBJECT_DEFAULT(PresetLike, py::object, isAnything)
};

/// Failure where there is none of this name, or the file is at fault.
Preset presetFrom(const PresetLike& given);

} // namespace tactum::python

namespace pybind11::detail {
template <> struct handle_type_name<tactum::python::PresetLike> {
    static constexpr auto name = const_name("Union[Preset, str, os.PathLike]");
};
} // namespace pybind11::detail
