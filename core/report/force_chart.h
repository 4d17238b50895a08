// The forces of a touch over time, as a drawing. For this folder only.
#pragma once

#include <string>

#include "core/haptics/replay.h"

namespace tactum {

inline constexpr int kChartWidth = 640, kChartHeight = 280; ///< pixels

/// SVG: all of the force, and its part along the surface. Black on white, for paper; the lines differ by more
/// than their colours. Needs a row at least.
std::string forceChart(const TouchTrace& rows);

} // namespace tactum
