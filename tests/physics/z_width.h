// The Z-width of a loop: how stiff a wall it renders before it swings.
#pragma once

#include "tests/physics/press.h"

namespace tactum::test {

inline constexpr double kSoftestWall = 50, kStiffestWall = 12800; ///< N/m, of the search

/// The first stiffness, N/m, at which pressing or hitting a plain sampled wall does not end at rest (T4),
/// within five percent; kStiffestWall if there is none below, kSoftestWall if all of them swing.
double firstFailure(const Bench& bench);

/// The loops of the map, in the order of its rows.
std::vector<Bench> mapLoops();

} // namespace tactum::test
