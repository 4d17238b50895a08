// Presets: those that lie beside the module, and files.
#include <algorithm>
#include <filesystem>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "app/python/package_folder.h"
#include "app/python/preset_of.h"
#include "core/base/text.h"
#include "core/presets/preset_file.h"

namespace tactum::python {
namespace {

namespace fs = std::filesystem;

const std::string kEnding = "." + std::string(kPresetEnding);

std::vector<std::string> presetNames() {
    std::vector<std::string> names;
    std::error_code fault;
    for (const auto& entry : fs::directory_iterator(packageFolder() / "presets", fault))
        if (entry.path().extension() == kEnding) names.push_back(entry.path().stem().string());
    std::ranges::sort(names);
    return names;
}

/// A word without folder and ending is a name; every other one is a file.
fs::path fileOf(const fs::path& given) {
    if (given.has_parent_path() || given.has_extension()) return given;
    const fs::path file = packageFolder() / "presets" / (given.string() + kEnding);
    std::error_code fault;
    if (!fs::exists(file, fault))
        throw Failure("there is no preset " + inQuotes(given.string()) +
                      "; tactum.presets() lists those that there are");
    return file;
}

LoadedPreset loaded(const fs::path& given) {
    return unlocked([file = fileOf(given)](const Progress&) { return readPreset(file); });
}

py::dict valuesOf(const LoadedPreset& of) {
    py::dict values;
    for (std::size_t i = 0; i < kMaterialFields.size(); ++i)
        if (of.preset.values[i])
            values[py::str(pythonName(kMaterialFields[i].parameter->key))] = *of.preset.values[i];
    return values;
}

py::dict sourcesOf(const LoadedPreset& of) {
    py::dict sources;
    for (const auto& [key, source] : of.preset.sources)
        sources[py::str(pythonName(key))] = source.words;
    return sources;
}

} // namespace

Preset presetFrom(const PresetLike& given) {
    if (py::isinstance<LoadedPreset>(given)) return given.cast<const LoadedPreset&>().preset;
    if (py::isinstance<py::str>(given) || py::hasattr(given, "__fspath__"))
        return loaded(given.cast<fs::path>()).preset;
    throw Failure("preset: is a Preset, the name of one, or a file");
}

void bindPreset(py::module_& module) {
    py::class_<LoadedPreset>(
        module, "Preset",
        "A named feel that can be given to any surface (Surface.apply, Scene.apply). Immutable.")
        .def(py::init(&loaded), py::arg("name"),
             "The preset of this name (tactum.presets()), or of a file. An Error where there is none or the "
             "file is at fault.")
        .def_property_readonly(
            "name", [](const LoadedPreset& of) { return of.preset.name; }, "str: What people call it.")
        .def_property_readonly(
            "category", [](const LoadedPreset& of) { return of.preset.category; }, "str: May be empty.")
        .def_property_readonly("values", valuesOf,
                               "Dict[str, float]: What it sets, by the names and in the units of "
                               "tactum.parameters; the rest of a surface stays.")
        .def_property_readonly("sources", sourcesOf,
                               "Dict[str, str]: Where each value comes from: a citation, or whose choice.")
        .def_property_readonly(
            "notes", [](const LoadedPreset& of) { return of.notes; },
            "List[str]: What of the file could not become a part of it.")
        .def("__repr__", [](const LoadedPreset& of) { return "<Preset " + inQuotes(of.preset.name) + ">"; });
    module.def("presets", presetNames, "The names of the presets that come with the package, sorted.");
}

} // namespace tactum::python
