// The answer of everything that can fail because of its input: a value, or one sentence for the person.
#pragma once

#include <string>
#include <utility>

#include <tl/expected.hpp>

namespace tactum {

/// Why something failed, for the person who can repair it. `text` is one line: what, where, what to do.
struct Error {
    /// Whose fault it is; the command line turns it into its exit code.
    enum class Kind { Input = 1, Usage = 2, Machine = 3 };
    Kind kind = Kind::Input;
    std::string text;
};

template <class T> using Result = tl::expected<T, Error>;

/// The input is at fault (exit code 1).
inline tl::unexpected<Error> inputError(std::string text) {
    return tl::unexpected<Error>(Error{Error::Kind::Input, std::move(text)});
}
/// The machine failed us: disk, memory, device (exit code 3).
inline tl::unexpected<Error> machineError(std::string text) {
    return tl::unexpected<Error>(Error{Error::Kind::Machine, std::move(text)});
}

} // namespace tactum
