// Whether a mesh has an inside.
#pragma once

#include "core/geometry/triangle_soup.h"

namespace tactum {

/// Whether every edge has its counterpart in the other direction and the fronts look outward. By one sum over
/// hashes of the edges instead of a search for each: some 20 ns a triangle, mistaken once in 2^64. Places
/// count, not indices. Thread: any but real time.
bool isClosed(const TriangleSoup& soup);

} // namespace tactum
