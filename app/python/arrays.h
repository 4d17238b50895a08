// Numbers between numpy and the core: what comes in is checked, what goes out is an array.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "core/base/vec.h"
#include "core/geometry/triangle_soup.h"
#include "core/scene/finger_path.h"

namespace tactum::python {

namespace py = pybind11;

inline bool isAnything(PyObject* object) {
    return object != nullptr;
}

/// Whatever numpy makes an array of. Its name in signatures says what is expected.
struct ArrayLike : py::object {
    PYBIND11_OBJECT_DEFAULT(ArrayLike, py::object, isAnything)
};
/// An array of float64 that is given back.
struct FloatArray : py::object {
    PYBIND11_OBJECT_DEFAULT(FloatArray, py::object, isAnything)
};
/// The same of whole numbers.
struct IntArray : py::object {
    PYBIND11_OBJECT_DEFAULT(IntArray, py::object, isAnything)
};

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Real, finite numbers of any layout and any real type, as float64 row by row; `what` is named in errors.
Numbers numbersOf(const py::handle& values, const std::string& what);
/// One finite number.
double numberOf(const py::handle& value, const std::string& what);
/// Three of them, each within 1e6.
Vec3 vectorOf(const py::handle& values, const std::string& what);
/// (w, x, y, z) of any length but 0.
Quat rotationOf(const py::handle& values, const std::string& what);
/// Whole numbers from 0 to below `end`, an array of `columns` a row, or of one dimension for 1.
std::vector<Index> indicesOf(const py::handle& values, const std::string& what, std::size_t columns,
                             std::size_t end);

/// A finger path: rows of t, x, y, z; or of x, y, z at `rate` steps a second, 1000 if nothing else is said.
std::vector<FingerPoint> fingerPathOf(const py::handle& rows, std::optional<double> rate);

FloatArray arrayOf(const Vec3& v);
/// (w, x, y, z).
FloatArray arrayOf(const Quat& q);
/// Rows of three.
FloatArray arrayOf(std::span<const Vec3> rows);
FloatArray arrayOf(std::span<const FingerPoint> path);

/// Shows memory of `owner`, which lives as long as the array does, without a copy. Not to be written to.
template <class T>
py::array viewOf(const T* data, std::vector<py::ssize_t> shape, const std::shared_ptr<const void>& owner) {
    using Hold = std::shared_ptr<const void>;
    const py::capsule keep(new Hold(owner), [](void* hold) { delete static_cast<Hold*>(hold); });
    py::array_t<T> array(std::move(shape), data, keep);
    array.attr("setflags")(py::arg("write") = false);
    return array;
}

} // namespace tactum::python

namespace pybind11::detail {
template <> struct handle_type_name<tactum::python::ArrayLike> {
    static constexpr auto name = const_name("numpy.typing.ArrayLike");
};
template <> struct handle_type_name<tactum::python::FloatArray> {
    static constexpr auto name = const_name("numpy.typing.NDArray[numpy.float64]");
};
template <> struct handle_type_name<tactum::python::IntArray> {
    static constexpr auto name = const_name("numpy.typing.NDArray[numpy.int64]");
};
} // namespace pybind11::detail
