#include "core/collision/sweep_memory.h"

#include <algorithm>

namespace tactum {

namespace {

// How far to gather around a path, in its radii: far where the mesh is coarse, so that it is seldom done
// anew, and near where it is so dense that not all of it would find room.
constexpr double kFirstMargin = 0.5, kMinMargin = 0.5, kMaxMargin = 2;
// How far the planes of leaves are kept, in radii: their rounding grows with it.
constexpr double kPlanesReach = 8;

void gatherAround(SweepMemory& memory, const CollisionMesh& mesh, const SpherePath& path) {
    const Neighbourhood& near = memory.near;
    double factor = 1;
    if (near.radius >= 0) factor = near.crowded ? 0.7 : near.blocks <= Neighbourhood::kBlocks / 2 ? 1.4 : 1;
    memory.margin = std::clamp(memory.margin * factor, kMinMargin * path.radius, kMaxMargin * path.radius);
    mesh.tree.gather(path.from, path.radius + memory.margin, memory.near);
}

SweepHit sweepNear(SweepMemory& memory, const CollisionMesh& mesh, const SpherePath& path,
                   std::span<const Index> excluded) {
    return mesh.tree.sweep(*mesh.soup, path, excluded, memory.leafHint, &memory.near, &memory.planes);
}

} // namespace

SweepHit sweepFrom(SweepMemory& memory, const CollisionMesh& mesh, const SpherePath& path,
                   std::span<const Index> excluded) noexcept {
    if (memory.mesh != &mesh) {
        memory.mesh = &mesh;
        memory.leafHint = 0;
        memory.margin = kFirstMargin * path.radius;
        memory.near.radius = -1;
        memory.planes.reach = -1;
    }
    if (!memory.planes.hold(path.from)) memory.planes.startAt(path.from, kPlanesReach * path.radius);
    SweepHit hit;
    if (!memory.near.holds(path)) {
        const double length = path.motion.norm();
        const double part = std::min(1.0, 0.9 * memory.margin / length);
        SpherePath begin = path;
        begin.motion *= part;
        if (!memory.near.holds(begin)) gatherAround(memory, mesh, path);
        hit = sweepNear(memory, mesh, begin, excluded);
        if (hit.t <= 1)
            hit.t *= part;
        else if (part < 1)
            hit = mesh.tree.sweep(*mesh.soup, path, excluded, memory.leafHint, nullptr, &memory.planes);
    } else {
        hit = sweepNear(memory, mesh, path, excluded);
    }
    if (hit.t <= 1) memory.leafHint = hit.leaf;
    return hit;
}

} // namespace tactum
