// Coherence of successive sweeps: what lies around the proxy is gathered once and swept many times.
#pragma once

#include <span>

#include "core/collision/collision_mesh.h"
#include "core/collision/leaf_planes.h"

namespace tactum {

/// What a proxy remembers of one mesh between sweeps. It makes them faster and never changes what they find
/// but among ties. Zero-cost to forget: assign {}.
struct SweepMemory {
    const CollisionMesh* mesh = nullptr; ///< whose it is; another one starts afresh
    Index leafHint = 0;                  ///< where the last sweep hit
    double margin = 0;                   ///< how far around the proxy was gathered, m
    Neighbourhood near;
    LeafPlanes planes;
};

/// SphereTree::sweep with a memory. Thread: real time.
SweepHit sweepFrom(SweepMemory& memory, const CollisionMesh& mesh, const SpherePath& path,
                   std::span<const Index> excluded) noexcept;

} // namespace tactum
