// The numbers that an author can set, as the one table of the program says them.
#pragma once

#include <string>
#include <vector>

#include <tactum/export.h>

namespace tactum::library {

/// One number. Its key is what set() and get() take, what files and the command line say.
struct Parameter {
    std::string key;      ///< "static-friction"
    std::string of;       ///< whose it is: "surface", "layer" or "scene"
    std::string label;    ///< on the screen: "Static friction"
    std::string unit;     ///< SI; empty for a ratio
    std::string sentence; ///< what it does, with its source
    double minimum = 0, maximum = 0, initial = 0;
};

/// All of them. Thread: any but real time.
TACTUM_API std::vector<Parameter> parameters();

} // namespace tactum::library
