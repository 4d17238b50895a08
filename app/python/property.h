// The properties of scenes, objects, surfaces and layers in Python: each said once, for reading, for setting
// by name and for its docstring. Numbers come from the parameter table of the core.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <pybind11/pybind11.h>

#include "app/python/arrays.h"
#include "app/python/failure.h"
#include "core/surface/parameter.h"

namespace tactum::python {

/// "static-friction" as Python writes it: "static_friction".
std::string pythonName(std::string_view key);
/// "from 0 to 2", with the unit.
std::string rangeOf(const Parameter& parameter);
/// "float: Static friction, from 0 to 2, at first 0. What it does."
std::string docOf(const Parameter& parameter);
/// The number where the parameter allows it; `name` is named in errors, else the parameter's own.
double allowed(const Parameter& parameter, const py::handle& value, std::string name = {});
/// True and False, of Python or numpy.
bool truthOf(const py::handle& value, const std::string& what);
std::string wordOf(const py::handle& value, const std::string& what);

/// One property of a T. `doc` begins with its type and a colon.
template <class T> struct Property {
    std::string name, doc;
    std::function<py::object(const T&)> get;
    std::function<void(T&, const py::handle&)> set; ///< empty: it is only read
};
template <class T> using Properties = std::vector<Property<T>>;

/// `name`: in Python, else that of the parameter.
template <class T>
Property<T> number(const Parameter& parameter, std::function<double(const T&)> get,
                   std::function<void(T&, double)> set, std::string name = {}) {
    if (name.empty()) name = pythonName(parameter.key);
    return {name, docOf(parameter), [get = std::move(get)](const T& of) { return py::float_(get(of)); },
            [&parameter, name, set = std::move(set)](T& of, const py::handle& value) {
                set(of, allowed(parameter, value, name));
            }};
}

/// Three numbers, within 1e6.
template <class T> Property<T> vector(std::string name, const std::string& doc, Vec3 T::*member) {
    return {name, "numpy.typing.NDArray[numpy.float64]: " + doc,
            [member](const T& of) { return arrayOf(of.*member); },
            [name, member](T& of, const py::handle& value) { of.*member = vectorOf(value, name); }};
}

template <class T> Property<T> truth(std::string name, std::string doc, bool T::*member) {
    return {name, std::move(doc), [member](const T& of) { return py::bool_(of.*member); },
            [name, member](T& of, const py::handle& value) { of.*member = truthOf(value, name); }};
}

/// One of the keys of a table like kTextureBlends. `access` gives the enumerator in a T.
template <class T, class Names, class Access>
Property<T> choice(std::string name, const std::string& doc, const Names& names, Access access) {
    std::string keys;
    for (const auto& one : names)
        keys += (keys.empty() ? "" : ", ") + std::string(one.key);
    return {name, "str: " + doc + ": " + keys + ".",
            [&names, access](const T& of) {
                return py::str(std::string(names[std::size_t(access(const_cast<T&>(of)))].key));
            },
            [&names, access, name, keys](T& of, const py::handle& value) {
                const std::string word = wordOf(value, name);
                for (std::size_t i = 0; i < std::size(names); ++i)
                    if (names[i].key == word) {
                        auto& to = access(of);
                        to = std::remove_reference_t<decltype(to)>(i);
                        return;
                    }
                throw Failure(name + ": \"" + word + "\" is none of " + keys);
            }};
}

template <class T> const Property<T>& named(const Properties<T>& all, const std::string& name) {
    std::string names;
    for (const Property<T>& one : all) {
        if (one.name == name && one.set) return one;
        if (one.set) names += (names.empty() ? "" : ", ") + one.name;
    }
    throw Failure("\"" + name + "\" cannot be set here; there are " + names);
}

/// All of them or none. In the order of the properties, not of the words: of two that pull each other along
/// the later one has the last word.
template <class T> T changed(T of, const Properties<T>& all, const py::kwargs& values) {
    for (const auto& given : values)
        named(all, std::string(py::str(given.first)));
    for (const Property<T>& one : all)
        if (values.contains(one.name.c_str())) one.set(of, py::object(values[one.name.c_str()]));
    return of;
}

/// What Python holds of a T gets another one: its get() is the T itself, or it has a put().
template <class T, class Handle> void put(Handle& of, T value) {
    if constexpr (requires { of.put(std::move(value)); })
        of.put(std::move(value));
    else
        of.get() = std::move(value);
}

/// Properties of a part as those of the whole; `part` gives it in a T, where const has been taken off.
template <class T, class Part, class Access> Properties<T> lifted(const Properties<Part>& of, Access part) {
    Properties<T> all;
    for (const Property<Part>& one : of) {
        Property<T> made{one.name,
                         one.doc,
                         [&one, part](const T& whole) { return one.get(part(const_cast<T&>(whole))); },
                         {}};
        if (one.set)
            made.set = [&one, part](T& whole, const py::handle& value) { one.set(part(whole), value); };
        all.push_back(std::move(made));
    }
    return all;
}

/// Declares them for what Python holds of a T.
template <class T, class Handle, class... Options>
void declare(py::class_<Handle, Options...>& to, const Properties<T>& all) {
    for (const Property<T>& one : all) {
        const py::cpp_function read([&one](Handle& of) { return one.get(of.get()); });
        if (!one.set) {
            to.def_property_readonly(one.name.c_str(), read, one.doc.c_str());
            continue;
        }
        const py::cpp_function write([&one](Handle& of, const py::object& value) {
            T changed = of.get();
            one.set(changed, value);
            put(of, std::move(changed));
        });
        to.def_property(one.name.c_str(), read, write, one.doc.c_str());
    }
}

/// Several of them at once, by their names.
template <class T, class Handle> void setAll(Handle& of, const Properties<T>& all, const py::kwargs& values) {
    put(of, changed<T>(of.get(), all, values));
}

} // namespace tactum::python
