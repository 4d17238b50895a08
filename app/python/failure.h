// What C++ answers, for Python: a value or tactum.Error with the same sentence, and work without the GIL that
// Ctrl+C ends.
#pragma once

#include <atomic>
#include <chrono>
#include <exception>
#include <optional>
#include <string>
#include <type_traits>

#include <pybind11/pybind11.h>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace tactum::python {

namespace py = pybind11;

/// Becomes tactum.Error.
struct Failure : std::exception {
    explicit Failure(std::string text) : sentence(std::move(text)) {}
    const char* what() const noexcept override { return sentence.c_str(); }
    std::string sentence;
};

/// Teaches the module to raise `error` for each Failure, and for what the standard library throws.
void raiseFailuresAs(const py::object& error);

template <class T> T valueOf(Result<T> result) {
    if (!result) throw Failure(result.error().text);
    if constexpr (!std::is_void_v<T>) return std::move(*result);
}

/// Asks Python ten times a second whether a signal came, Ctrl+C for one, and cancels the work then. Signals
/// are heard on Python's main thread alone.
class Signals {
public:
    /// For the work. Thread: any, without the GIL.
    Progress progress();
    /// Raises what the handler of the signal raised. Thread: with the GIL.
    void raise();

private:
    void look();

    std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now();
    std::atomic<bool> cancelled_{false};
    std::optional<py::error_already_set> raised_;
};

/// What work(progress) gives, done while the GIL is free: no object of Python may be touched in it.
template <class Work> auto unlocked(const Work& work) {
    Signals signals;
    auto result = [&] {
        const py::gil_scoped_release free;
        return work(signals.progress());
    }();
    signals.raise();
    return valueOf(std::move(result));
}

} // namespace tactum::python
