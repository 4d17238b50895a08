// Fingers that stroke any mesh, from its triangles alone.
#pragma once

#include <vector>

#include "tests/support/exactness.h"

namespace tactum::bench {

/// A finger, one place a millisecond: from outside down into the surface, then along it.
struct Stroke {
    double speed = 0; ///< m/s
    double depth = 0; ///< under the surface, about, m
    std::vector<Vec3> finger;
    std::size_t approach = 0; ///< rows until it goes along
};

/// The stroke of that number: every twelve have each of four speeds, 0.05 to 0.2 m/s, with each of three
/// depths, 1 to 5 mm. It begins 6 mm away from the surface and goes along it for `rows` rows. The same for
/// the same mesh.
Stroke strokeOver(const test::TriangleGrid& grid, int number, std::size_t rows);

} // namespace tactum::bench
