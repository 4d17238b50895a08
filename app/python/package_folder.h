// Where the package lies, with what it brings along.
#pragma once

#include <filesystem>

#include <pybind11/pybind11.h>
#include <pybind11/stl/filesystem.h>

namespace tactum::python {

/// The folder of tactum/__init__.py. Thread: with the GIL.
inline std::filesystem::path packageFolder() {
    const pybind11::str file = pybind11::module_::import("tactum").attr("__file__");
    return std::filesystem::path(std::string(file)).parent_path();
}

} // namespace tactum::python
