#include "app/python/touch_arrays.h"

#include <algorithm>

namespace tactum::python {
namespace {

using Shape = std::vector<py::ssize_t>;

/// The arrays of a Touch, filled row by row.
class Columns {
public:
    explicit Columns(const Shape& scalars)
        : t_(scalars), finger_(vectors(scalars)), proxy_(vectors(scalars)), force_(vectors(scalars)),
          contacts_(scalars) {}

    void add(const TouchRow& row) {
        *tTo_++ = row.t;
        fingerTo_ = std::copy_n(row.finger.data(), 3, fingerTo_);
        proxyTo_ = std::copy_n(row.proxy.data(), 3, proxyTo_);
        forceTo_ = std::copy_n(row.force.data(), 3, forceTo_);
        *contactsTo_++ = row.contacts;
    }

    TouchObject touch() const {
        const auto type = py::module_::import("tactum.results").attr("Touch");
        return TouchObject(type(proxy_, force_, contacts_, t_, finger_));
    }

private:
    static Shape vectors(Shape scalars) {
        scalars.push_back(3);
        return scalars;
    }

    py::array_t<double> t_, finger_, proxy_, force_;
    py::array_t<std::int64_t> contacts_;
    double *tTo_ = t_.mutable_data(), *fingerTo_ = finger_.mutable_data(), *proxyTo_ = proxy_.mutable_data(),
           *forceTo_ = force_.mutable_data();
    std::int64_t* contactsTo_ = contacts_.mutable_data();
};

} // namespace

TouchObject touchOf(const TouchTrace& rows) {
    Columns columns({py::ssize_t(rows.size())});
    for (const TouchRow& row : rows)
        columns.add(row);
    return columns.touch();
}

TouchObject touchOf(std::span<const TouchTrace> traces) {
    Columns columns({py::ssize_t(traces.size()), traces.empty() ? 0 : py::ssize_t(traces.front().size())});
    for (const TouchTrace& rows : traces)
        for (const TouchRow& row : rows)
            columns.add(row);
    return columns.touch();
}

} // namespace tactum::python
