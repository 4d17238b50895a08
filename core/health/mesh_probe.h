// What of a mesh the proxy cannot feel as it should: walls thinner than it, and parts that it never comes to.
#pragma once

#include <vector>

#include "core/collision/collision_mesh.h"
#include "core/geometry/mesh_problems.h"
#include "core/geometry/sides.h"

namespace tactum {

/// Triangles behind which, straight inward from their middle, another sheet of the same mesh lies within the
/// proxy's diameter and shows its back: a wall, or a blade, that a fingertip is thicker than. Sheets that
/// look to the probe are another body's front or a mesh that is inside out, and no wall; so is a sheet at the
/// very place. One probe for each triangle: of a large one the thin end may be missed. Where the proxy's
/// diameter is more than a hundredth of the mesh and the triangles are many, only some of them, evenly, are
/// probed: four million short looks are the bound. `proxyRadius` in m. About 2 s for a million triangles on
/// two cores, with the tree at hand. Fails only when cancelled. Thread: any but real time; uses all cores.
Result<Problem> thinWalls(const FaceGraph& graph, const SphereTree& tree, double proxyRadius,
                          const Progress& progress = {});

/// Parts of the mesh that lie inside another part which lets no proxy in. A part is what hangs together over
/// edges. It lets none in when it is closed, or no opening of it is as wide as the proxy (the box of its rim
/// has a diagonal below the diameter), and its surfaces are felt from outside. What is not felt from there
/// lets the proxy through, so sides alone never make anything unreachable.
///
/// The 64 largest parts are taken as shells; whether another one is inside is judged by 32 of its corners.
/// `sides`: of each surface; empty: all from both. O(n log n). Fails only when cancelled. Thread: any but
/// real time; uses all cores.
Result<Problem> unreachableParts(const FaceGraph& graph, const std::vector<Sides>& sides, double proxyRadius,
                                 const Progress& progress = {});

} // namespace tactum
