// What of a mesh the proxy cannot feel as it should: parts that it never comes to. However thin a wall is,
// the proxy stays on its side of it.
#pragma once

#include <vector>

#include "core/collision/collision_mesh.h"
#include "core/geometry/mesh_problems.h"
#include "core/geometry/sides.h"

namespace tactum {

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
