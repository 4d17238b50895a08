// A scene: opened, changed, touched and written.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "app/python/mesh_of.h"
#include "app/python/package_folder.h"
#include "app/python/preset_of.h"
#include "app/python/scene_handles.h"
#include "app/python/scene_touch.h"
#include "app/python/sweep.h"
#include "app/python/touch_arrays.h"
#include "core/base/text.h"
#include "core/bundle/write_scene.h"
#include "core/files/save_scene.h"
#include "core/import/import_scene.h"
#include "core/scene/bodies.h"
#include "core/scene/findings.h"
#include "core/scene/placing.h"
#include "core/scene/world_fields.h"

namespace tactum::python {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> linesOf(const std::vector<Finding>& findings) {
    std::vector<std::string> lines;
    for (const Finding& finding : findings)
        lines.push_back(lineOf(finding));
    return lines;
}

/// The import process that came with the package, or the program's.
ImportOptions importOptions() {
    ImportOptions options;
    std::error_code fault;
    const fs::path ours = packageFolder() / "tactum-import";
    if (fs::exists(ours, fault)) options.worker = ours;
    return options;
}

double unitNamed(const std::string& unit) {
    if (const auto metres = metresOf(unit)) return *metres;
    throw Failure("unit: " + inQuotes(unit) + " is none of m, cm, mm and in");
}

void placeIn(Scene& scene, const std::string& unit, const std::string& up, std::optional<double> fit) {
    if (up != "y" && up != "z") throw Failure("up: " + inQuotes(up) + " is neither y nor z");
    if (fit && !(*fit >= 1e-6 && *fit <= 1e6)) throw Failure("fit: is not from 1e-6 to 1e6 m");
    if (const double metres = unitNamed(unit); metres != 1) scaleScene(scene, metres, Vec3::Zero());
    if (up == "z" && !turnUpright(scene))
        throw Failure("up: the scene has bodies, which stand as their gravity is; leave it out");
    if (fit) fitDiagonal(scene, *fit);
}

SceneHold openScene(const fs::path& file, const std::string& unit, const std::string& up,
                    std::optional<double> fit) {
    auto loaded = unlocked([&, options = importOptions()](const Progress& progress) {
        return importScene(file, progress, options);
    });
    placeIn(loaded.scene, unit, up, fit);
    return std::make_shared<OpenScene>(
        OpenScene{std::move(loaded.scene), linesOf(loaded.findings), file, nullptr});
}

std::vector<std::string> convert(const OpenScene& of, const fs::path& file) {
    const WrittenScene written = unlocked([&, scene = of.scene](const Progress& progress) {
        OutputPlaces places{file, {}, {}};
        if (!of.source.empty()) places.inputs.push_back(of.source);
        return writeScene(scene, places, progress);
    });
    std::vector<std::string> lines;
    for (const Loss& loss : written.losses)
        if (loss.kind != LossKind::Kept) lines.push_back(lineOf(loss));
    return lines;
}

void save(const OpenScene& of, const fs::path& file) {
    if (lowerCase(file.extension().string()) != std::string(".") + kSceneEnding)
        throw Failure(file.string() + ": a scene is saved as .glb; convert() writes other formats");
    unlocked([&, scene = of.scene](const Progress& progress) { return saveScene(scene, file, progress, 0); });
}

ObjectHandle objectNamed(const SceneHold& of, const std::string& name) {
    for (const SceneObject& object : of->scene.objects)
        if (object.name == name) return {of, object.id};
    throw Failure("the scene has no object " + inQuotes(name));
}

std::vector<ObjectHandle> objectsOf(const SceneHold& of) {
    std::vector<ObjectHandle> all;
    for (const SceneObject& object : of->scene.objects)
        all.push_back({of, object.id});
    return all;
}

void removeObject(const SceneHold& of, const ObjectHandle& object) {
    if (object.of != of) throw Failure("the object is of another scene");
    object.get(); // is there
    removeMechanics(of->scene, object.id);
    std::erase_if(of->scene.objects, [&](const SceneObject& one) { return one.id == object.id; });
}

TouchObject touch(OpenScene& of, const py::object& path, std::optional<double> rate) {
    const auto points = pathFor(of, path, rate);
    const auto world = compiled(of);
    return touchOf(unlocked([&](const Progress& progress) { return replay(*world, points, progress); }));
}

/// All surfaces of the scene, of an object, or one.
std::vector<SurfaceHandle> surfacesIn(const SceneHold& of, const py::object& where) {
    std::vector<SurfaceHandle> surfaces;
    if (where.is_none())
        surfaces = surfacesOf(of);
    else if (py::isinstance<ObjectHandle>(where))
        surfaces = surfacesOf(where.cast<ObjectHandle>());
    else if (py::isinstance<SurfaceHandle>(where))
        surfaces = {where.cast<SurfaceHandle>()};
    else
        throw Failure("where: is an Object, a Surface, or nothing for all");
    for (const SurfaceHandle& surface : surfaces) {
        surface.get(); // is there
        if (surface.object.of != of) throw Failure("where: is of another scene");
    }
    return surfaces;
}

TouchObject sweep(const SceneHold& of, const std::string& name, const ArrayLike& values,
                  const py::object& path, std::optional<double> rate, const py::object& where) {
    const auto points = pathFor(*of, path, rate);
    return touchOf(touched(*of, sweepOf(*of, name, values, surfacesIn(of, where)), points));
}

using SceneClass = py::class_<OpenScene, SceneHold>;

void declareParts(SceneClass& scene) {
    scene.def_property_readonly("objects", objectsOf, "List[Object]: In their order.")
        .def_property_readonly(
            "surfaces", [](const SceneHold& of) { return surfacesOf(of); },
            "List[Surface]: Of all objects, in their order.")
        .def_property_readonly("bodies", bodiesOf, "List[Body]: What forces move, in their order.")
        .def("__getitem__", objectNamed, py::arg("name"), "The first object of this name.")
        .def_property(
            "path",
            [](const OpenScene& of) -> py::object {
                if (!of.scene.finger) return py::none();
                return arrayOf(std::span<const FingerPoint>(*of.scene.finger));
            },
            [](OpenScene& of, const py::object& path) {
                of.scene.finger =
                    path.is_none()
                        ? nullptr
                        : std::make_shared<const std::vector<FingerPoint>>(fingerPathOf(path, std::nullopt));
            },
            "Optional[numpy.typing.NDArray[numpy.float64]]: The stroke that shows what there is to feel, "
            "rows "
            "of t, x, y, z in s and m; None where there is none.")
        .def_property_readonly(
            "findings", [](const OpenScene& of) { return of.findings; },
            "List[str]: What the reader repaired, left out or doubts, a sentence each.")
        .def_property_readonly(
            "bounds",
            [](const OpenScene& of) {
                const Bounds bounds = boundsOf(of.scene);
                const std::array<Vec3, 2> corners{bounds.low, bounds.high};
                return arrayOf(std::span<const Vec3>(corners));
            },
            "numpy.typing.NDArray[numpy.float64]: The box around all objects, low and high corner in m, "
            "world's frame.");
}

void declareEdits(SceneClass& scene) {
    scene
        .def("add_mesh", addMesh, py::arg("vertices"), py::arg("triangles"), py::arg("surfaces") = py::none(),
             py::arg("name") = "mesh",
             "A new object of a mesh: vertices (n, 3) in m, triangles (m, 3) of whole numbers, "
             "counter-clockwise from the front; surfaces (m,), of each triangle the place of its surface.\n\n"
             "What is at fault with the mesh is repaired as in a file and told in findings. An Error for "
             "arrays that are none.")
        .def("remove", removeObject, py::arg("object"), "Takes an object away, with what hangs on it.")
        .def(
            "set",
            [](const SceneHold& of, const py::kwargs& values) {
                for (const SurfaceHandle& surface : surfacesOf(of))
                    setAll(surface, surfaceProperties(), values);
            },
            "Sets properties of all surfaces: set(stiffness=400). An Error names what cannot be.")
        .def(
            "apply",
            [](const SceneHold& of, const PresetLike& given) {
                const Preset preset = presetFrom(given);
                for (const SurfaceHandle& surface : surfacesOf(of))
                    surface.get() = applied(surface.get(), preset);
            },
            py::arg("preset"), "Gives all surfaces a preset: a Preset, a name of one, or a file.")
        .def(
            "copy", [](const OpenScene& of) { return std::make_shared<OpenScene>(of); },
            "A scene of its own with the same content. Cheap: meshes are shared.")
        .def(
            "check",
            [](const OpenScene& of) {
                return linesOf(unlocked([scene = of.scene](const Progress&) {
                    return Result<std::vector<Finding>>(validate(scene));
                }));
            },
            "What may be wrong with it, a sentence each: what `tactum check` says.");
}

void declareWork(SceneClass& scene) {
    scene
        .def(
            "touch", touch, py::arg("path") = py::none(), py::arg("rate") = py::none(),
            "What a finger feels along a path: proxy (n, 3) in m, force (n, 3) in N on the finger, before "
            "any "
            "device's limit, contacts (n,), each a row of the path; to the bit those of `tactum touch`.\n\n"
            "path: rows of t, x, y, z in s and m, world's frame; or of x, y, z at `rate` Hz (1000); or a CSV "
            "file; nothing: the scene's own. Thread: any; others go on meanwhile, and Ctrl+C ends it.")
        .def(
            "sweep", sweep, py::arg("name"), py::arg("values"), py::arg("path") = py::none(),
            py::arg("rate") = py::none(), py::arg("where") = py::none(),
            "touch() for each value of one parameter, on all processors; the arrays have an axis more in "
            "front. The scene stays as it is.\n\n"
            "name: a number of tactum.parameters; where: an Object or a Surface, else all of them. Of static "
            "and dynamic friction the other one follows, so that dynamic is never above static. An Error "
            "for a value out of range.")
        .def("save", save, py::arg("file"),
             "As .glb, which every viewer shows and which opens again bit for bit; whole or not at all.")
        .def("convert", convert, py::arg("file"),
             "Writes it by the ending: .glb, .gltf, .tactum or .zip (bundles), .x3d, .obj, .ply, .stl, .off. "
             "What is degraded or lost there, a sentence each.");
}

} // namespace

const Properties<Scene>& sceneProperties() {
    static const Properties<Scene> all = [] {
        Properties<Scene> made{number<Scene>(
                                   kProxyRadius, [](const Scene& of) { return of.proxyRadius; },
                                   [](Scene& of, double value) { of.proxyRadius = value; }),
                               number<Scene>(
                                   kShellRadius, [](const Scene& of) { return of.reach.shell; },
                                   [](Scene& of, double value) { of.reach.shell = value; }),
                               choice<Scene>("reach", "How hands reach beyond their device's workspace",
                                             kReachChoices,
                                             [](Scene& of) -> ReachMode& { return of.reach.mode; })};
        for (const WorldField& field : kWorldFields)
            made.push_back(number<Scene>(
                *field.parameter, [&field](const Scene& of) { return of.mechanics.*field.value; },
                [&field](Scene& of, double value) { of.mechanics.*field.value = value; }));
        made.push_back(
            {"gravity",
             "numpy.typing.NDArray[numpy.float64]: What bodies fall with, in m/s^2, world's frame.",
             [](const Scene& of) { return arrayOf(of.mechanics.gravity); },
             [](Scene& of, const py::handle& value) { of.mechanics.gravity = vectorOf(value, "gravity"); }});
        return made;
    }();
    return all;
}

void bindScene(py::module_& module) {
    SceneClass scene(module, "Scene",
                     "What can be touched: objects with surfaces, in SI units, y up. Of a file by "
                     "tactum.open(), or empty. Thread: any, one at a time.");
    scene.def(py::init([] { return std::make_shared<OpenScene>(); }), "An empty one.");
    declare(scene, sceneProperties());
    declareParts(scene);
    declareEdits(scene);
    declareWork(scene);
    scene.def("__repr__", [](const OpenScene& of) {
        return "<Scene of " + counted(of.scene.objects.size(), "object") + ", " +
               counted(triangleCount(of.scene), "triangle") + ">";
    });
    module.def(
        "open", openScene, py::arg("file"), py::arg("unit") = "m", py::arg("up") = "y",
        py::arg("fit") = py::none(),
        "Opens a file as a Scene: glTF, bundles, OBJ, PLY, STL, OFF, X3D, FBX, DAE, 3DS, 3MF.\n\n"
        "unit: what one unit of a file is that does not say: m, cm, mm or in; up: y or z; fit: its "
        "diagonal is made so many m. The file is read by a process of its own that a broken one cannot "
        "leave. An Error says file, place and remedy. Thread: any; others go on meanwhile.");
}

} // namespace tactum::python
