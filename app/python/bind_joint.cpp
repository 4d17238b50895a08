// A joint that holds a body: a hinge, a slider, a path.
#include <cmath>

#include <pybind11/stl.h>

#include "app/python/body_of.h"
#include "core/base/text.h"

namespace tactum::python {
namespace {

constexpr std::string_view kKinds[] = {"hinge", "slider", "path"}; // as AxisKind

/// "hinge-low" as a property of a joint: "low".
std::string nameOf(const AxisField& field) {
    return pythonName(field.hinge->key.substr(std::string_view("hinge-").size()));
}

std::string docOf(const AxisField& field) {
    const std::string angle(field.hinge->sentence), way(field.slider->sentence);
    return "float: " + std::string(field.hinge->label) + ": " + rangeOf(*field.hinge) + " of a hinge, " +
           rangeOf(*field.slider) + " of a slider or a path" +
           (field.isStop() ? "; without a stop it is infinite" : "") + ".\n\n" + angle +
           (way == angle ? "" : " Of a slider: " + way) + "\nAn Error where it is out of its range.";
}

/// Beyond all ends a stop is none, as it is at the end of its range.
double valueOf(const AxisField& field, const AxisJoint& joint, const py::handle& value) {
    if (field.isStop() && py::isinstance<py::float_>(value) && value.cast<double>() == field.endless())
        return field.endless();
    return allowed(field.of(joint.kind), value, nameOf(field));
}

Property<AxisJoint> axisNumber(const AxisField& field) {
    return {nameOf(field), docOf(field),
            [&field](const AxisJoint& of) { return py::float_(of.*field.value); },
            [&field](AxisJoint& of, const py::handle& value) {
                setFigure(of, field, valueOf(field, of, value));
            }};
}

Property<AxisJoint> directionOfJoint() {
    auto axis = vector("axis",
                       "The direction of its axis, of length 1, world's frame, at the time 0: a hinge turns "
                       "counter-clockwise about it. Of a path none.",
                       &AxisJoint::axis);
    axis.set = [set = axis.set](AxisJoint& of, const py::handle& value) {
        set(of, value);
        if (!(of.axis.norm() > 1e-9)) throw Failure("axis: has no length that says a direction");
        of.axis.normalize();
    };
    return axis;
}

} // namespace

AxisKind axisKindNamed(const std::string& kind) {
    if (kind == kKinds[0]) return AxisKind::Hinge;
    if (kind == kKinds[1]) return AxisKind::Slider;
    throw Failure("kind: " + inQuotes(kind) + " is neither hinge nor slider");
}

const Properties<AxisJoint>& jointProperties() {
    static const Properties<AxisJoint> all = [] {
        Properties<AxisJoint> made{
            vector("at", "A point of its axis, in m, world's frame, at the time 0.", &AxisJoint::at),
            directionOfJoint()};
        for (const AxisField& field : kAxisFields)
            made.push_back(axisNumber(field));
        return made;
    }();
    return all;
}

void bindJoint(py::module_& module) {
    py::class_<JointHandle> joint(
        module, "Joint",
        "What holds a body: a hinge or a slider, which leaves one axis free, or a path. Along that axis it "
        "has stops, a spring, a damper, dry friction, a motor and detents, each where its numbers are not 0. "
        "At the time 0 its angle or way is 0. Setting a property changes the scene. Of a joint of a file "
        "that leaves more free only `kind` is known. Thread: any, one at a time.");
    declare(joint, jointProperties());
    joint
        .def_property_readonly(
            "kind",
            [](const JointHandle& of) {
                of.expectThere();
                const auto axis = axisJointOf(of.body.of->scene, of.body.id, of.index);
                return axis ? std::string(kKinds[std::size_t(axis->kind)]) : "other";
            },
            "str: hinge, slider, path or other.")
        .def_property_readonly(
            "body", [](const JointHandle& of) { return of.body; }, "Body: That it holds.")
        .def_property_readonly(
            "to",
            [](const JointHandle& of) {
                const BodyId to = of.get().to;
                return to == kWorldBody ? std::nullopt : std::optional(BodyHandle{of.body.of, to});
            },
            "Optional[Body]: The body that it is fixed to; None: the world.")
        .def_property_readonly(
            "index", [](const JointHandle& of) { return of.index; },
            "int: Its place among those of the body.")
        .def(
            "set",
            [](const JointHandle& of, const py::kwargs& values) { setAll(of, jointProperties(), values); },
            "Several properties at once, all or none: set(low=0, high=1.5). An Error names what cannot be.")
        .def(
            "remove",
            [](const JointHandle& of) {
                of.expectThere();
                removeJoint(of.body.of->scene, of.body.id, of.index);
            },
            "Takes it away. Those behind it move up.")
        .def("__repr__", [](const JointHandle& of) {
            return "<Joint " + std::to_string(of.index) + " of " + inQuotes(of.body.get().name) + ">";
        });
}

} // namespace tactum::python
