// A body that forces move, with its joints.
#include <pybind11/stl.h>

#include "app/python/body_of.h"
#include "core/base/text.h"

namespace tactum::python {
namespace {

Property<RigidBody> nameOfBody() {
    return {"name", "str: Its name in the file.", [](const RigidBody& of) { return py::str(of.name); },
            [](RigidBody& of, const py::handle& value) {
                of.name = printable(wordOf(value, "name"), kLongestName);
            }};
}

std::vector<ObjectHandle> objectsOn(const BodyHandle& of) {
    of.get(); // is there
    std::vector<ObjectHandle> all;
    for (const SceneObject& object : of.of->scene.objects)
        if (object.body == of.id) all.push_back({of.of, object.id});
    return all;
}

BodyId otherEnd(const BodyHandle& of, const std::optional<BodyHandle>& to) {
    if (!to) return kWorldBody;
    to->get(); // is there
    if (to->of != of.of) throw Failure("to: is of another scene");
    if (to->id == of.id) throw Failure("to: is the body itself");
    return to->id;
}

JointHandle addJoint(const BodyHandle& of, const std::string& kind, const std::optional<BodyHandle>& to,
                     const py::kwargs& values) {
    of.get(); // is there
    AxisJoint joint = guessedJoint(of.of->scene, of.id, axisKindNamed(kind));
    joint.to = otherEnd(of, to);
    joint = changed(std::move(joint), jointProperties(), values);
    const std::size_t index = tactum::jointsOf(of.of->scene, of.id);
    setAxisJoint(of.of->scene, of.id, joint, index);
    return {of, index};
}

void declareMade(py::class_<BodyHandle>& body) {
    body.def_property_readonly("objects", objectsOn, "List[Object]: That move with it.")
        .def_property_readonly(
            "joints", [](const BodyHandle& of) { return jointsOf(of); },
            "List[Joint]: That hold it; those that hold others to it are among theirs. The first one is what "
            "it hangs on, others close loops.")
        .def_property_readonly(
            "id", [](const BodyHandle& of) { return of.id; }, "int: Names it for its whole life, from 1.")
        .def_property_readonly(
            "centre", [](const BodyHandle& of) { return arrayOf(of.get().pose.apply(of.get().centre)); },
            "numpy.typing.NDArray[numpy.float64]: Its centre of mass at the time 0, in m, world's frame.")
        .def_property_readonly(
            "inertia", [](const BodyHandle& of) { return arrayOf(of.get().inertia); },
            "numpy.typing.NDArray[numpy.float64]: Its principal moments about the centre, in kg m^2; they "
            "change with the mass. 0: infinite.");
}

} // namespace

BodyHandle bodyMadeOf(const ObjectHandle& of) {
    SceneObject& object = of.get();
    if (object.body != kWorldBody) throw Failure(inQuotes(object.name) + " moves with a body already");
    if (object.motion) throw Failure(inQuotes(object.name) + " moves by its keys, and cannot by forces too");
    const BodyId id = makeBody(of.of->scene, of.id);
    if (id == kWorldBody) throw Failure(inQuotes(object.name) + " has no triangles that a body could be of");
    return {of.of, id};
}

const Properties<RigidBody>& bodyProperties() {
    static const Properties<RigidBody> all{
        nameOfBody(),
        number<RigidBody>(
            kBodyMass, [](const RigidBody& of) { return of.mass; }, setMass, "mass"),
        number<RigidBody>(
            kGravityFactor, [](const RigidBody& of) { return of.gravityFactor; },
            [](RigidBody& of, double value) { of.gravityFactor = value; }, "gravity_factor"),
        vector("velocity", "Of its centre at the time 0, in m/s, world's frame.", &RigidBody::velocity),
        vector("angular_velocity", "At the time 0, in rad/s, world's frame.", &RigidBody::angularVelocity),
        truth("kinematic", "bool: Whether it goes on with its velocity whatever happens.",
              &RigidBody::kinematic)};
    return all;
}

void bindBody(py::module_& module) {
    py::class_<BodyHandle> body(
        module, "Body",
        "What forces move: gravity, joints, other bodies and the finger. Made by Object.make_body(). Setting "
        "a property changes the scene. Thread: any, one at a time.");
    declare(body, bodyProperties());
    declareMade(body);
    body.def("add_joint", addJoint, py::arg("kind") = "hinge", py::arg("to") = py::none(),
             "Holds it by one more joint.\n\n"
             "kind: hinge or slider; to: the Body that it is fixed to, else the world. Further words are "
             "properties of a Joint: add_joint('hinge', at=(0, 0, 0), axis=(0, 1, 0), high=1.5). Without "
             "`at` and `axis` they are those that the form of the body suggests. An Error names what cannot "
             "be.")
        .def(
            "make_still",
            [](const BodyHandle& of) {
                of.get(); // is there
                makeStill(of.of->scene, of.id);
            },
            "Its objects stay where they are at the time 0; the body is no more, and no joint of it.")
        .def(
            "set",
            [](const BodyHandle& of, const py::kwargs& values) { setAll(of, bodyProperties(), values); },
            "Several properties at once, all or none: set(mass=0.4, gravity_factor=0). An Error names what "
            "cannot be.")
        .def("__eq__", [](const BodyHandle& a, const BodyHandle& b) { return a.of == b.of && a.id == b.id; })
        .def("__hash__", [](const BodyHandle& of) { return of.id; })
        .def("__repr__", [](const BodyHandle& of) { return "<Body " + inQuotes(of.get().name) + ">"; });
}

} // namespace tactum::python
