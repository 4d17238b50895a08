// The parameter table, as Python sees it.
#include <pybind11/stl.h>

#include "app/python/scene_handles.h"
#include "core/scene/world_fields.h"

namespace tactum::python {
namespace {

/// A Parameter and whose it is.
struct ListedParameter {
    const Parameter* parameter;
    std::string_view of;
};

py::dict allParameters() {
    py::dict all;
    const auto list = [&all](const Parameter& parameter, std::string_view of) {
        all[py::str(pythonName(parameter.key))] = ListedParameter{&parameter, of};
    };
    for (const MaterialField& field : kMaterialFields)
        list(*field.parameter, "surface");
    list(kCreaseAngle, "surface");
    for (const Parameter* parameter : {&kTextureHeight, &kTextureRatio, &kTextureOpacity})
        list(*parameter, "layer");
    for (const PatternField& field : kPatternFields)
        list(*field.parameter, "layer");
    list(kProxyRadius, "scene");
    return all;
}

template <class Get>
void declareText(py::class_<ListedParameter>& to, const char* name, const char* doc, Get get) {
    to.def_property_readonly(
        name, [get](const ListedParameter& of) { return std::string(get(of)); }, doc);
}

void declareNumber(py::class_<ListedParameter>& to, const char* name, const char* doc,
                   double Parameter::*member) {
    to.def_property_readonly(
        name, [member](const ListedParameter& of) { return of.parameter->*member; }, doc);
}

} // namespace

void bindParameters(py::module_& module) {
    py::class_<ListedParameter> parameter(
        module, "Parameter",
        "A number that an author can set, as the core's table says it: the same for the window, the command "
        "line and Python. Immutable.");
    declareText(parameter, "name", "str: As a property here, e.g. 'static_friction'.",
                [](const ListedParameter& of) { return pythonName(of.parameter->key); });
    declareText(parameter, "key", "str: In files and on the command line, e.g. 'static-friction'.",
                [](const ListedParameter& of) { return of.parameter->key; });
    declareText(parameter, "label", "str: On the screen, e.g. 'Static friction'.",
                [](const ListedParameter& of) { return of.parameter->label; });
    declareText(parameter, "unit", "str: SI; empty for a ratio.",
                [](const ListedParameter& of) { return of.parameter->unit; });
    declareText(parameter, "sentence", "str: What it does, with its source.",
                [](const ListedParameter& of) { return of.parameter->sentence; });
    declareText(parameter, "of", "str: Whose it is: 'surface', 'layer' or 'scene'.",
                [](const ListedParameter& of) { return of.of; });
    declareNumber(parameter, "minimum", "float: The least that is allowed, in its unit.",
                  &Parameter::minimum);
    declareNumber(parameter, "maximum", "float: The most that is allowed, in its unit.", &Parameter::maximum);
    declareNumber(parameter, "initial", "float: What it is at first, in its unit.", &Parameter::initial);
    declareNumber(parameter, "step", "float: A notch of the wheel in the window, in its unit.",
                  &Parameter::step);
    parameter.def("__repr__", [](const ListedParameter& of) {
        return "<Parameter " + pythonName(of.parameter->key) + ": " +
               docOf(*of.parameter).substr(std::string_view("float: ").size()) + ">";
    });
    module.attr("parameters") = allParameters();
}

} // namespace tactum::python
