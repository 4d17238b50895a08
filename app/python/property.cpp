#include "app/python/property.h"

#include <algorithm>

#include "core/base/numbers.h"

namespace tactum::python {
namespace {

std::string textOf(double value) {
    std::string text;
    appendNumber(text, value);
    return text;
}

std::string unitOf(const Parameter& parameter) {
    return parameter.unit.empty() ? "" : " " + std::string(parameter.unit);
}

} // namespace

std::string rangeOf(const Parameter& parameter) {
    return "from " + textOf(parameter.minimum) + " to " + textOf(parameter.maximum) + unitOf(parameter);
}

std::string pythonName(std::string_view key) {
    std::string name(key);
    std::ranges::replace(name, '-', '_');
    return name;
}

std::string docOf(const Parameter& parameter) {
    return "float: " + std::string(parameter.label) + ", " + rangeOf(parameter) + ", at first " +
           textOf(parameter.initial) + ".\n\n" + std::string(parameter.sentence) +
           "\nAn Error where it is out of its range.";
}

double allowed(const Parameter& parameter, const py::handle& value, std::string name) {
    if (name.empty()) name = pythonName(parameter.key);
    const double number = numberOf(value, name);
    if (!parameter.allows(number))
        throw Failure(name + ": " + textOf(number) + " is not " + rangeOf(parameter));
    return number;
}

bool truthOf(const py::handle& value, const std::string& what) {
    const std::string type = py::str(py::type::of(value).attr("__name__"));
    if (type != "bool" && type != "bool_") throw Failure(what + ": is True or False");
    return value.cast<bool>();
}

std::string wordOf(const py::handle& value, const std::string& what) {
    if (!py::isinstance<py::str>(value)) throw Failure(what + ": is a text");
    return value.cast<std::string>();
}

} // namespace tactum::python
