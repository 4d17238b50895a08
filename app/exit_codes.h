// What the program's exit codes mean, as the man page says it.
#pragma once

#include <array>

namespace tactum {

struct ExitCode {
    int code;
    const char* meaning;
};

inline constexpr std::array<ExitCode, 4> kExitCodes{
    {{0, "done"},
     {1, "the input is at fault, or a recording gives other bits now"},
     {2, "wrong usage"},
     {3, "the machine failed: disk, device, display"}}};

} // namespace tactum
