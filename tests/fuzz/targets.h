// What is fuzzed: each reader with the bytes of a file, and what has to hold for whatever it accepts.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace tactum::fuzz {

struct Target {
    std::string_view name;
    void (*read)(std::string_view bytes);
    bool isContainer = false; ///< a glb whose parts are changed, not its bytes
};

std::span<const Target> targets();

} // namespace tactum::fuzz
