// The formulas of those samples that are felt from pictures: for whoever holds a stroke against them.
#pragma once

#include <cstddef>

namespace tactum::samples {

// Along a panel's own axes from its lower left corner, x to the right and y up, m.
double brickHeight(double x, double y);
double tileHeight(double x, double y);
/// Which of the panel's surfaces is there.
std::size_t brickSurface(double x, double y);
std::size_t tileSurface(double x, double y);

/// From the middle of the coin, x to the right and y away from the person.
double coinHeight(double x, double y);

} // namespace tactum::samples
