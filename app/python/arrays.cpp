#include "app/python/arrays.h"

#include <algorithm>
#include <cmath>

#include "app/python/failure.h"
#include "core/base/text.h"
#include "core/geometry/soup_builder.h"

namespace tactum::python {
namespace {

std::string shapeOf(const py::array& array) {
    return py::str(array.attr("shape"));
}

/// An array of whatever, or the sentence that none can be made of it.
py::array arrayFrom(const py::handle& values, const std::string& what) {
    auto array = py::array::ensure(values);
    if (!array) throw Failure(what + ": is no array of numbers; its rows have to be of one length");
    return array;
}

} // namespace

Numbers numbersOf(const py::handle& values, const std::string& what) {
    const py::array array = arrayFrom(values, what);
    if (std::string_view("fiu").find(array.dtype().kind()) == std::string_view::npos)
        throw Failure(what + ": holds " + std::string(py::str(array.dtype())) +
                      ", and real numbers are wanted");
    auto numbers = Numbers::ensure(array);
    if (!numbers) throw Failure(what + ": cannot become float64");
    const std::span<const double> all(numbers.data(), std::size_t(numbers.size()));
    if (!std::ranges::all_of(all, [](double value) { return std::isfinite(value); }))
        throw Failure(what + ": has a number that is not finite");
    return numbers;
}

double numberOf(const py::handle& value, const std::string& what) {
    const double number = PyFloat_AsDouble(value.ptr());
    if (PyErr_Occurred()) {
        PyErr_Clear();
        throw Failure(what + ": " + printable(std::string(py::repr(value))) + " is no number");
    }
    if (!std::isfinite(number)) throw Failure(what + ": is not finite");
    return number;
}

Vec3 vectorOf(const py::handle& values, const std::string& what) {
    const Numbers numbers = numbersOf(values, what);
    if (numbers.ndim() != 1 || numbers.size() != 3)
        throw Failure(what + ": has the shape " + shapeOf(numbers) + ", and x, y, z are wanted");
    const Vec3 v(numbers.at(0), numbers.at(1), numbers.at(2));
    if (!std::ranges::all_of(v, isCoordinate)) throw Failure(what + ": is farther than 1e6 from the origin");
    return v;
}

Quat rotationOf(const py::handle& values, const std::string& what) {
    const Numbers numbers = numbersOf(values, what);
    if (numbers.ndim() != 1 || numbers.size() != 4)
        throw Failure(what + ": has the shape " + shapeOf(numbers) + ", and w, x, y, z are wanted");
    const Quat q(numbers.at(0), numbers.at(1), numbers.at(2), numbers.at(3));
    if (!(q.norm() > 1e-6 && q.norm() < 1e6)) throw Failure(what + ": has no length that says a direction");
    return unitLength(q);
}

std::vector<Index> indicesOf(const py::handle& values, const std::string& what, std::size_t columns,
                             std::size_t end) {
    const py::array array = arrayFrom(values, what);
    const bool shaped =
        columns == 1 ? array.ndim() == 1 : array.ndim() == 2 && std::size_t(array.shape(1)) == columns;
    if (!shaped)
        throw Failure(what + ": has the shape " + shapeOf(array) + ", and rows of " +
                      std::to_string(columns) + " are wanted");
    if (std::string_view("iu").find(array.dtype().kind()) == std::string_view::npos)
        throw Failure(what + ": holds " + std::string(py::str(array.dtype())) +
                      ", and whole numbers are wanted");
    const auto whole = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>::ensure(array);
    std::vector<Index> indices;
    for (const std::int64_t index : std::span(whole.data(), std::size_t(whole.size()))) {
        if (index < 0 || std::uint64_t(index) >= end)
            throw Failure(what + ": names " + std::to_string(index) + ", and there are " +
                          std::to_string(end));
        indices.push_back(Index(index));
    }
    return indices;
}

std::vector<FingerPoint> fingerPathOf(const py::handle& rows, std::optional<double> rate) {
    const Numbers numbers = numbersOf(rows, "path");
    const bool timed = numbers.ndim() == 2 && numbers.shape(1) == 4;
    if (timed && rate) throw Failure("path: has its own times; leave the rate out, or give rows of x, y, z");
    if (!timed && (numbers.ndim() != 2 || numbers.shape(1) != 3))
        throw Failure("path: has the shape " + shapeOf(numbers) +
                      ", and rows of t, x, y, z or of x, y, z are wanted");
    if (numbers.size() == 0) throw Failure("path: has no rows");
    const double perSecond = rate.value_or(1000);
    if (!(perSecond >= 1 && perSecond <= 1e6)) throw Failure("rate: is not from 1 to 1,000,000 Hz");
    std::vector<FingerPoint> path;
    const double* at = numbers.data();
    for (py::ssize_t i = 0; i < numbers.shape(0); ++i, at += numbers.shape(1)) {
        const double* x = timed ? at + 1 : at;
        path.push_back({timed ? *at : double(i) / perSecond, {x[0], x[1], x[2]}});
    }
    if (!isFingerPath(path))
        throw Failure("path: its times have to rise, and its places to be within 1e6 m of the origin");
    return path;
}

FloatArray arrayOf(const Vec3& v) {
    return FloatArray(py::array_t<double>(3, v.data()));
}

FloatArray arrayOf(const Quat& q) {
    const double wxyz[] = {q.w(), q.x(), q.y(), q.z()};
    return FloatArray(py::array_t<double>(4, wxyz));
}

FloatArray arrayOf(std::span<const Vec3> rows) {
    return FloatArray(py::array_t<double>({py::ssize_t(rows.size()), py::ssize_t(3)},
                                          reinterpret_cast<const double*>(rows.data())));
}

FloatArray arrayOf(std::span<const FingerPoint> path) {
    py::array_t<double> rows({py::ssize_t(path.size()), py::ssize_t(4)});
    double* to = rows.mutable_data();
    for (const FingerPoint& point : path) {
        *to++ = point.t;
        to = std::copy_n(point.position.data(), 3, to);
    }
    return FloatArray(rows);
}

} // namespace tactum::python
