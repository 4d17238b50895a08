// An object of a scene: its place, its mesh, its surfaces.
#include <algorithm>
#include <array>

#include <pybind11/stl.h>

#include "app/python/body_of.h"
#include "app/python/preset_of.h"
#include "core/base/text.h"
#include "core/scene/arrange.h"
#include "core/scene/findings.h"
#include "core/scene/object_bounds.h"

namespace tactum::python {
namespace {

Property<SceneObject> nameOfObject() {
    return {"name", "str: Its name in the file.", [](const SceneObject& of) { return py::str(of.name); },
            [](SceneObject& of, const py::handle& value) {
                of.name = printable(wordOf(value, "name"), kLongestName);
            }};
}

void place(const ObjectHandle& of, const Pose& pose) {
    of.get(); // is there
    placeObject(of.of->scene, of.id, pose);
}

const TriangleSoup& meshOf(const ObjectHandle& of) {
    static const TriangleSoup kNothing;
    const auto& mesh = of.get().geometry;
    return mesh ? *mesh : kNothing;
}

void declarePlace(py::class_<ObjectHandle>& object) {
    object
        .def_property(
            "position", [](const ObjectHandle& of) { return arrayOf(of.get().pose.translation); },
            [](const ObjectHandle& of, const ArrayLike& value) {
                place(of, {of.get().pose.rotation, vectorOf(value, "position")});
            },
            "numpy.typing.NDArray[numpy.float64]: Where its origin is, x, y, z in m in the world's frame, at "
            "the time 0. What hangs on it moves along. An Error beyond 1e6 m.")
        .def_property(
            "rotation", [](const ObjectHandle& of) { return arrayOf(of.get().pose.rotation); },
            [](const ObjectHandle& of, const ArrayLike& value) {
                place(of, {rotationOf(value, "rotation"), of.get().pose.translation});
            },
            "numpy.typing.NDArray[numpy.float64]: How it is turned, a quaternion w, x, y, z from its frame "
            "to the world's.")
        .def_property_readonly(
            "bounds",
            [](const ObjectHandle& of) {
                const Bounds bounds = tactum::boundsOf(of.get());
                const std::array<Vec3, 2> corners{bounds.low, bounds.high};
                return arrayOf(std::span<const Vec3>(corners));
            },
            "numpy.typing.NDArray[numpy.float64]: The box around it, low and high corner in m, world's "
            "frame.");
}

void declareMesh(py::class_<ObjectHandle>& object) {
    object
        .def_property_readonly(
            "vertices",
            [](const ObjectHandle& of) {
                const auto& all = meshOf(of).positions;
                return viewOf(reinterpret_cast<const double*>(all.data()), {py::ssize_t(all.size()), 3},
                              of.get().geometry);
            },
            "numpy.typing.NDArray[numpy.float64]: Its corners, (n, 3) in m, its own frame. Not a copy, and "
            "read only.")
        .def_property_readonly(
            "triangles",
            [](const ObjectHandle& of) {
                const auto& all = meshOf(of).triangles;
                return viewOf(reinterpret_cast<const Index*>(all.data()), {py::ssize_t(all.size()), 3},
                              of.get().geometry);
            },
            "numpy.typing.NDArray[numpy.uint32]: (m, 3) places in vertices, counter-clockwise from the "
            "front. Not a copy, and read only.")
        .def_property_readonly(
            "surface_of",
            [](const ObjectHandle& of) {
                const auto& all = meshOf(of).surfaceOf;
                return viewOf(all.data(), {py::ssize_t(all.size())}, of.get().geometry);
            },
            "numpy.typing.NDArray[numpy.uint32]: (m,) of each triangle the place of its surface. Not a copy, "
            "and read only.");
}

SurfaceHandle surfaceNamed(const ObjectHandle& of, const std::string& name) {
    for (const SurfaceHandle& surface : surfacesOf(of))
        if (surface.get().name == name) return surface;
    throw Failure(inQuotes(of.get().name) + " has no surface " + inQuotes(name));
}

void declareSurfaces(py::class_<ObjectHandle>& object) {
    object
        .def_property_readonly(
            "surfaces", [](const ObjectHandle& of) { return surfacesOf(of); },
            "List[Surface]: In their order.")
        .def("__getitem__", surfaceNamed, py::arg("name"), "Its first surface of this name.")
        .def(
            "set",
            [](const ObjectHandle& of, const py::kwargs& values) {
                for (const SurfaceHandle& surface : surfacesOf(of))
                    setAll(surface, surfaceProperties(), values);
            },
            "Sets properties of all its surfaces: set(stiffness=400). An Error names what cannot be.")
        .def(
            "apply",
            [](const ObjectHandle& of, const PresetLike& given) {
                const Preset preset = presetFrom(given);
                for (const SurfaceHandle& surface : surfacesOf(of))
                    surface.get() = applied(surface.get(), preset);
            },
            py::arg("preset"), "Gives all its surfaces a preset: a Preset, a name of one, or a file.");
}

void declareBody(py::class_<ObjectHandle>& object) {
    object
        .def_property_readonly(
            "body",
            [](const ObjectHandle& of) {
                const BodyId id = of.get().body;
                return id == kWorldBody ? std::nullopt : std::optional(BodyHandle{of.of, id});
            },
            "Optional[Body]: That it moves with; None: no force moves it.")
        .def("make_body", bodyMadeOf,
             "Makes it a loose body of the density of water, and of all that stands still something that "
             "bodies can lie on. What others meet of it is convex, for each of its parts. An Error where it "
             "moves already, or has no triangles.");
}

} // namespace

const Properties<SceneObject>& objectProperties() {
    static const Properties<SceneObject> all{
        nameOfObject(), truth("visible", "bool: Whether it is seen and felt.", &SceneObject::visible)};
    return all;
}

void bindObject(py::module_& module) {
    py::class_<ObjectHandle> object(
        module, "Object",
        "A mesh of a scene, with its place and its surfaces. Setting a property changes the scene. Thread: "
        "any, one at a time.");
    declare(object, objectProperties());
    declarePlace(object);
    declareMesh(object);
    declareSurfaces(object);
    declareBody(object);
    object
        .def_property_readonly(
            "id", [](const ObjectHandle& of) { return of.id; },
            "int: Names it for its whole life, from 1; the number that the server knows it by too.")
        .def("__eq__",
             [](const ObjectHandle& a, const ObjectHandle& b) { return a.of == b.of && a.id == b.id; })
        .def("__hash__", [](const ObjectHandle& of) { return of.id; })
        .def("__repr__", [](const ObjectHandle& of) {
            return "<Object " + inQuotes(of.get().name) + ", " +
                   counted(meshOf(of).triangles.size(), "triangle") + ">";
        });
}

} // namespace tactum::python
