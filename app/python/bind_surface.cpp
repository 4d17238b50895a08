// A surface of an object: how it feels, and its layers of texture.
#include <pybind11/stl.h>

#include "app/python/preset_of.h"
#include "app/python/scene_handles.h"
#include "app/python/texture_of.h"
#include "core/base/text.h"

namespace tactum::python {
namespace {

constexpr NamedChoice kNormalSources[] = {{"file", ""}, {"computed", ""}};
// As kSidesNames, in the form of the other choices.
constexpr NamedChoice kSides[] = {
    {kSidesNames[0], ""}, {kSidesNames[1], ""}, {kSidesNames[2], ""}, {kSidesNames[3], ""}};

/// The two coefficients of friction pull each other along as in the window: dynamic is never above static.
Property<Surface> materialNumber(const MaterialField& field) {
    return number<Surface>(
        *field.parameter, [&field](const Surface& of) { return of.material.*field.value; },
        [&field](Surface& of, double value) { of.material = withValue(of.material, field, value); });
}

Property<Surface> nameOfSurface() {
    return {"name", "str: Its group or material in the file.",
            [](const Surface& of) { return py::str(of.name); },
            [](Surface& of, const py::handle& value) {
                of.name = printable(wordOf(value, "name"), kLongestName);
            }};
}

Property<Surface> shadingOfSurface() {
    return {"shading", "bool: Whether it feels smooth although it is made of facets.",
            [](const Surface& of) { return py::bool_(of.shading.on); },
            [](Surface& of, const py::handle& value) { of.shading.on = truthOf(value, "shading"); }};
}

LayerHandle addLayer(const SurfaceHandle& of, const std::string& source, const py::object& image,
                     const py::object& paint, const py::object& mask, const py::kwargs& values) {
    Surface& surface = of.get();
    if (surface.layers.size() >= std::size_t(kMaxTextureLayers))
        throw Failure("a surface has at most " + std::to_string(kMaxTextureLayers) + " layers");
    surface.layers.push_back(layerOf(source, {image, paint}, mask, values, of.object.vertices()));
    return {of, surface.layers.size() - 1};
}

void declareLayers(py::class_<SurfaceHandle>& surface) {
    surface
        .def_property_readonly(
            "layers", [](const SurfaceHandle& of) { return layersOf(of); },
            "List[Layer]: Its layers of haptic texture, lowest first.")
        .def(
            "add_layer", addLayer, py::arg("source") = "noise", py::arg("image") = py::none(),
            py::arg("paint") = py::none(), py::arg("mask") = py::none(),
            "A layer of haptic texture on top of the others.\n\n"
            "source: image, noise, grooves, dots, weave or painted; image: rows and columns of values from 0 "
            "to 1 for the first of them, row 0 at v = 0; paint: for the last one a value from 0 to 1 for "
            "each "
            "of the object's vertices; mask: where it counts, as for Layer.set_mask(). Further words are "
            "properties of a Layer: add_layer('grooves', size=2e-3, strength=1e-4). An Error at more than 16 "
            "layers.")
        .def(
            "remove_layer",
            [](const SurfaceHandle& of, std::size_t index) {
                auto& layers = of.get().layers;
                if (index >= layers.size()) throw Failure("there is no layer " + std::to_string(index));
                layers.erase(layers.begin() + std::ptrdiff_t(index));
            },
            py::arg("index"),
            "Takes away the layer at this place, 0 the lowest. An Error where there is none.");
}

} // namespace

const Properties<Surface>& surfaceProperties() {
    static const Properties<Surface> all = [] {
        Properties<Surface> made{nameOfSurface()};
        for (const MaterialField& field : kMaterialFields)
            made.push_back(materialNumber(field));
        made.push_back(shadingOfSurface());
        made.push_back(choice<Surface>("normals", "Where the normals of shading come from", kNormalSources,
                                       [](Surface& of) -> NormalSource& { return of.shading.normals; }));
        made.push_back(number<Surface>(
            kCreaseAngle, [](const Surface& of) { return of.shading.creaseAngle; },
            [](Surface& of, double value) { of.shading.creaseAngle = value; }));
        made.push_back(choice<Surface>("sides", "From which side it is felt", kSides,
                                       [](Surface& of) -> Sides& { return of.sides; }));
        made.push_back(truth("visible", "bool: Whether it is seen and felt.", &Surface::visible));
        return made;
    }();
    return all;
}

void bindSurface(py::module_& module) {
    py::class_<SurfaceHandle> surface(
        module, "Surface",
        "A part of an object with one feel, a group or material of the file. Its numbers are those of the "
        "parameter table (tactum.parameters); setting one changes the scene. Thread: any, one at a time.");
    declare(surface, surfaceProperties());
    declareLayers(surface);
    surface
        .def(
            "set",
            [](const SurfaceHandle& of, const py::kwargs& values) {
                setAll(of, surfaceProperties(), values);
            },
            "Several properties at once, all or none: set(stiffness=400, static_friction=0.5). An Error "
            "names "
            "what cannot be.")
        .def(
            "apply",
            [](const SurfaceHandle& of, const PresetLike& preset) {
                of.get() = applied(of.get(), presetFrom(preset));
            },
            py::arg("preset"),
            "Gives it a preset: a Preset, the name of one (tactum.presets()), or a file. What the preset "
            "does "
            "not set stays.")
        .def_property_readonly(
            "object", [](const SurfaceHandle& of) { return of.object; }, "Object: That it is on.")
        .def_property_readonly(
            "index", [](const SurfaceHandle& of) { return of.index; },
            "int: Its place among those of the object.")
        .def("__repr__", [](const SurfaceHandle& of) {
            return "<Surface " + inQuotes(of.get().name) + " of " + inQuotes(of.object.get().name) + ">";
        });
}

} // namespace tactum::python
