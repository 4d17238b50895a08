// A model in fewer triangles, for pictures in motion. Private to this folder.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "ui/view/display_mesh.h"

namespace tactum {

/// Triangles between vertices of a display mesh, and which triangle of its soup each stands for.
struct CoarseMesh {
    std::vector<std::array<int, 3>> corners;
    std::vector<Index> from;

    /// The surface of each.
    std::vector<Index> surfaceOf(const std::vector<Index>& exact) const;
};

/// About so many triangles: the vertices of each cell of a grid become the one that is nearest to their mean
/// (Rossignac and Borrel, Multi-resolution 3D approximations for rendering complex scenes, 1993). Surfaces
/// stay joined where they were, for a cell chooses for all of them. Thread: any but real time.
CoarseMesh coarseMesh(const DisplayMesh& mesh, std::size_t triangles);

} // namespace tactum
