// A parameter said once: what the inspector, the validation, the file, the command line and the manual know.
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

namespace tactum {

/// One number that an author can set.
struct Parameter {
    std::string_view key;   ///< in files and on the command line, e.g. "static-friction"
    std::string_view label; ///< on the screen, e.g. "Static friction"
    std::string_view unit;  ///< SI, empty for a ratio
    double minimum;
    double maximum;
    double step; ///< one notch of the wheel or one press of an arrow key
    double initial;
    int decimals;              ///< shown after the point
    std::string_view sentence; ///< what it does, with its source; the tooltip

    bool allows(double value) const { return std::isfinite(value) && value >= minimum && value <= maximum; }
    double clamped(double value) const {
        return std::isfinite(value) ? std::clamp(value, minimum, maximum) : initial;
    }
};

} // namespace tactum
