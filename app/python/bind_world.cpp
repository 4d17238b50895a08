// A scene that is touched step by step.
#include <algorithm>
#include <map>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "app/python/live_world.h"
#include "app/python/scene_handles.h"
#include "app/python/scene_touch.h"
#include "app/python/touch_arrays.h"
#include "core/base/atomic_file.h"
#include "core/haptics/compile.h"

namespace tactum::python {
namespace {

/// What one step gave, by itself.
struct Step {
    double time = 0;
    Vec3 finger = Vec3::Zero();
    HapticOutput output;
    std::shared_ptr<const World> world; ///< whose bodies the contacts name
    std::vector<PlacedObject> places;
};

/// One of its contacts.
struct Touched {
    ContactReport report;
    ObjectId object = 0;
};

std::vector<Touched> contactsOf(const Step& of) {
    std::vector<Touched> all;
    for (int i = 0; i < std::min(of.output.contacts, kMaxModelPlanes); ++i) {
        const ContactReport& report = of.output.contact[std::size_t(i)];
        all.push_back({report, of.world->bodies[report.body].object});
    }
    return all;
}

std::map<ObjectId, Pose> placesOf(const Step& of) {
    std::map<ObjectId, Pose> all;
    for (const PlacedObject& place : of.places)
        all[place.object] = place.pose;
    return all;
}

double stepLength(double dt) {
    if (!(dt >= 1e-6 && dt <= 1)) throw Failure("dt: is not from 1e-6 to 1 s");
    return dt;
}

Step stepOnce(LiveWorld& of, const ArrayLike& finger, double dt, const py::object& velocity) {
    FingerMove move{vectorOf(finger, "finger"), stepLength(dt), {}};
    if (!velocity.is_none()) move.velocity = vectorOf(velocity, "velocity");
    const LiveWorld::Turn turn(of);
    const py::gil_scoped_release free;
    const HapticOutput output = of.step(move);
    return {of.time(), move.finger, output, of.world(), of.places()};
}

TouchObject followed(LiveWorld& of, const ArrayLike& path, std::optional<double> rate) {
    const auto points = fingerPathOf(path, rate);
    const LiveWorld::Turn turn(of);
    return touchOf(unlocked([&](const Progress& progress) { return of.follow(points, progress); }));
}

void updated(LiveWorld& of, OpenScene& scene) {
    const LiveWorld::Turn turn(of);
    of.enter(unlocked([&of, scene = scene.scene](const Progress& progress) {
        return compile(scene, of.world().get(), progress);
    }));
}

void saveRecording(LiveWorld& of, const std::filesystem::path& file, const std::string& reason) {
    const LiveWorld::Turn turn(of);
    const Recording recording = of.recording(reason);
    unlocked([&](const Progress&) { return writeFileAtomically(file, recordingBytes(recording), 0); });
}

std::unique_ptr<LiveWorld> worldOf(OpenScene& scene, bool record) {
    return std::make_unique<LiveWorld>(compiled(scene), record);
}

void bindTouched(py::module_& module) {
    py::class_<Touched>(module, "Contact", "One place that a Step touches. Immutable.")
        .def_property_readonly(
            "point", [](const Touched& of) { return arrayOf(of.report.point); },
            "numpy.typing.NDArray[numpy.float64]: On the surface, in m, world's frame.")
        .def_property_readonly(
            "normal", [](const Touched& of) { return arrayOf(of.report.normal); },
            "numpy.typing.NDArray[numpy.float64]: Out of the surface toward the proxy, of length 1.")
        .def_property_readonly(
            "normal_force", [](const Touched& of) { return of.report.normalForce; }, "float: In N.")
        .def_property_readonly(
            "slipping", [](const Touched& of) { return of.report.slipping; },
            "bool: Whether it slides; else it sticks, or has no friction.")
        .def_property_readonly(
            "object", [](const Touched& of) { return of.object; }, "int: The id of its object.")
        .def_property_readonly(
            "surface", [](const Touched& of) { return of.report.surface; },
            "int: The place of its surface among those of the object.");
}

void bindStep(py::module_& module) {
    py::class_<Step>(module, "Step", "What one step of a World gave. Immutable.")
        .def_property_readonly(
            "time", [](const Step& of) { return of.time; }, "float: Of the World at its end, in s.")
        .def_property_readonly(
            "finger", [](const Step& of) { return arrayOf(of.finger); },
            "numpy.typing.NDArray[numpy.float64]: Where the finger is, in m, world's frame.")
        .def_property_readonly(
            "proxy", [](const Step& of) { return arrayOf(of.output.proxy); },
            "numpy.typing.NDArray[numpy.float64]: Where the proxy is, which stays outside, in m.")
        .def_property_readonly(
            "force", [](const Step& of) { return arrayOf(of.output.force); },
            "numpy.typing.NDArray[numpy.float64]: In N on the finger, before any device's limit.")
        .def_property_readonly("contacts", contactsOf, "List[Contact]: What is touched.")
        .def_property_readonly("places", placesOf,
                               "Dict[int, Place]: Where each object is that forces move, by its id.");
}

void bindPlace(py::module_& module) {
    py::class_<Pose>(module, "Place", "Where an object is in a Step. Immutable.")
        .def_property_readonly(
            "position", [](const Pose& of) { return arrayOf(of.translation); },
            "numpy.typing.NDArray[numpy.float64]: Of its origin, x, y, z in m, world's frame.")
        .def_property_readonly(
            "rotation", [](const Pose& of) { return arrayOf(of.rotation); },
            "numpy.typing.NDArray[numpy.float64]: How it is turned, a quaternion w, x, y, z from its frame "
            "to the world's.");
}

/// Along the one freedom of its joint; nothing where there is none.
std::optional<double> alongJoint(const BodyReading& of, double value) {
    return of.turns || of.slides ? std::optional(value) : std::nullopt;
}

void bindReading(py::module_& module) {
    py::class_<BodyReading>(module, "Reading", "How a body moves, after a step of a World. Immutable.")
        .def_property_readonly(
            "value", [](const BodyReading& of) { return alongJoint(of, of.value); },
            "Optional[float]: Of the joint that it hangs on, 0 at the time 0: the angle of a hinge in rad, "
            "else the way in m. None where that leaves more free.")
        .def_property_readonly(
            "rate", [](const BodyReading& of) { return alongJoint(of, of.rate); },
            "Optional[float]: How fast that changes, in rad/s or m/s.")
        .def_property_readonly(
            "force", [](const BodyReading& of) { return alongJoint(of, of.force); },
            "Optional[float]: What the joint does along it: spring, damper, motor, detents, friction and "
            "stops, in N m or N.")
        .def_property_readonly(
            "kinetic", [](const BodyReading& of) { return of.kinetic; }, "float: Its energy of motion, in J.")
        .def_property_readonly(
            "potential", [](const BodyReading& of) { return of.potential; },
            "float: Its energy of height, in J; 0 at the origin.");
}

BodyReading readingOf(LiveWorld& of, const BodyHandle& body) {
    const LiveWorld::Turn turn(of);
    return of.readingOf(body.id);
}

} // namespace

void bindWorld(py::module_& module) {
    bindTouched(module);
    bindPlace(module);
    bindStep(module);
    bindReading(module);
    py::class_<LiveWorld>(
        module, "World",
        "A scene compiled for touch, with the finger that is in it. A later change of the scene is felt "
        "after "
        "update(). Thread: any, one at a time, or an Error; the GIL is free during steps, so that threads "
        "with a World each go on beside each other.")
        .def(py::init(&worldOf), py::arg("scene"), py::arg("record") = false,
             "record: keeps the last minute of its steps for save().")
        .def("step", stepOnce, py::arg("finger"), py::arg("dt") = 1e-3, py::arg("velocity") = py::none(),
             "One haptic step: the finger at x, y, z (m, world's frame) after dt (s, 1e-6 to 1). velocity "
             "(m/s): else that of the way since the step before. An Error for what is not finite.")
        .def(
            "follow", followed, py::arg("path"), py::arg("rate") = py::none(),
            "A step for each row of t, x, y, z, or of x, y, z at `rate` Hz (1000), all without the GIL; from "
            "a new World the same as Scene.touch(). An Error where it begins before `time`. Ctrl+C ends it.")
        .def("update", updated, py::arg("scene"),
             "Feels the scene as it is now. Contacts and friction stay where no shape changed, and only what "
             "is new is compiled: a change of feel takes microseconds.")
        .def(
            "restart",
            [](LiveWorld& of) {
                const LiveWorld::Turn turn(of);
                of.restart();
            },
            "As it was at first: no contact, time 0, and nothing recorded.")
        .def("reading", readingOf, py::arg("body"),
             "How a Body moves after the last step, and what its joint does. An Error for one that no force "
             "moves in this World.")
        .def("save", saveRecording, py::arg("file"), py::arg("reason") = "saved by a script",
             "The last minute as a recording for tactum.play(), `tactum play` and the window. An Error "
             "without record=True.")
        .def_property_readonly(
            "time",
            [](LiveWorld& of) {
                const LiveWorld::Turn turn(of);
                return of.time();
            },
            "float: At the end of the last step, in s: the sum of all dt, or the path's time.");
}

} // namespace tactum::python
