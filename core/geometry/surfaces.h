// Parts of a mesh given to surfaces: split off, and brought together again.
#pragma once

#include <span>

#include "core/geometry/triangle_set.h"
#include "core/geometry/triangle_soup.h"

namespace tactum {

/// The same mesh with the triangles of the set on one surface. To split them off, let it be the first number
/// that is not in use. Surfaces that lose all their triangles keep their numbers.
/// Thread: any but real time, as for all here; some 30 ms for a million triangles, most of it copying.
TriangleSoup withSurface(const TriangleSoup& soup, const TriangleSet& set, Index surface);

/// How surfaces are called after some of them were merged: without holes, in their order.
struct MergedSurfaces {
    std::vector<Index> newNumber; ///< of each surface there was
    Index merged = 0;             ///< what they are now: the place of the lowest one
    Index count = 0;              ///< how many surfaces there are now
};

/// `surfaces`: those to merge, each below `count`, in any order; the lowest one stays. No surface to merge
/// leaves all as they are.
MergedSurfaces mergeSurfaces(Index count, std::span<const Index> surfaces);

/// The same mesh with every surface called anew. `newNumber` has an entry for every surface in use.
TriangleSoup renumbered(const TriangleSoup& soup, std::span<const Index> newNumber);

/// Square metres of the triangles of a set, in any order; some 10 ms for a million.
double areaOf(const TriangleSoup& soup, std::span<const Index> triangles);

} // namespace tactum
