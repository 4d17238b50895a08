// Numbers as colours that colour-blind eyes order too, and that stay in order in a grey print.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <QColor>

namespace tactum {

/// Viridis (Smith and van der Walt): dark violet over green to yellow for 0 to 1, lightness rising evenly.
/// Colours as on the screen; between nine of them linear, nowhere more than two of 255 beside the original.
inline QColor mapColour(double part) {
    struct Stop {
        double r, g, b;
    };
    constexpr std::array<Stop, 9> kStops{{{68, 1, 84},
                                          {71, 44, 122},
                                          {59, 81, 139},
                                          {44, 113, 142},
                                          {33, 144, 141},
                                          {39, 173, 129},
                                          {92, 200, 99},
                                          {170, 220, 50},
                                          {253, 231, 37}}};
    const double at = std::clamp(part, 0.0, 1.0) * (kStops.size() - 1);
    const std::size_t i = std::min(std::size_t(at), kStops.size() - 2);
    const double t = at - double(i);
    const Stop &a = kStops[i], &b = kStops[i + 1];
    const auto mix = [t](double x, double y) { return int(std::lround(x + t * (y - x))); };
    return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

} // namespace tactum
