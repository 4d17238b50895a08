// Another program, started beside this one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <sys/types.h>
#include <utility>
#include <vector>

namespace tactum {

/// It begins with no other descriptors than these, with every signal as it is by default.
struct ChildProgram {
    std::filesystem::path program;
    std::vector<std::string> arguments; ///< without the program's name
    std::vector<int> silent;            ///< descriptors that lead to nowhere: 0, 1 or 2
    /// Descriptors of ours and what they are there, in this order; the last has the largest number.
    std::vector<std::pair<int, int>> descriptors;
    std::optional<std::vector<char*>> environment; ///< without the null at its end; nothing: ours
    /// A session of its own: the terminal's signals are not for it.
    bool apart = false;
};

/// By posix_spawn, which shares the memory until the other program begins: a fork would make every page of
/// the force loops fault once. Returns 0, or the error's number. Thread: any but real time.
int startChild(ChildProgram program, pid_t& child);

/// Where a program of ours is that people do not start themselves: beside the running one, or in
/// libexec/tactum beside its folder, as it is installed. Empty when in neither. Thread: any but real time.
std::filesystem::path programBeside(const std::string& name);

} // namespace tactum
