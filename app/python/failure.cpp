#include "app/python/failure.h"

#include <new>

namespace tactum::python {

void raiseFailuresAs(const py::object& error) {
    static PyObject* type = nullptr; // as long as the process: translators are never taken back
    type = error.inc_ref().ptr();
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(thrown);
        } catch (const Failure& failure) {
            PyErr_SetString(type, failure.what());
        } catch (const std::bad_alloc&) {
            PyErr_SetString(type,
                            "there is not enough memory for this; close other programs, or ask for less");
        }
    });
}

Progress Signals::progress() {
    return {[this](double) { look(); }, &cancelled_};
}

void Signals::look() {
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(100);
    const py::gil_scoped_acquire lock;
    if (raised_ || PyErr_CheckSignals() == 0) return;
    raised_.emplace();
    cancelled_ = true;
}

void Signals::raise() {
    if (raised_) throw std::move(*raised_);
}

} // namespace tactum::python
