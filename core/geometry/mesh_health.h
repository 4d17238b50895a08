// What is unusual about a mesh, in numbers; and the one repair that touching it needs.
#pragma once

#include <cstddef>

#include "core/base/progress.h"
#include "core/geometry/triangle_soup.h"

namespace tactum {

/// Counts for the person, none of them an obstacle to touching. Vertices at the same place count as one, so
/// that meshes which split them for normals or textures are judged by their shape.
struct MeshHealth {
    std::size_t triangles = 0;      ///< with an area, however small
    std::size_t segments = 0;       ///< see TriangleSoup
    std::size_t points = 0;         ///< see TriangleSoup
    std::size_t slivers = 0;        ///< of the triangles: area below 1e-12 of the squared diagonal of the box
    std::size_t duplicateFaces = 0; ///< same three corners as an earlier triangle
    std::size_t nonManifoldEdges = 0;     ///< with more than two triangles
    std::size_t boundaryEdges = 0;        ///< with one triangle
    std::size_t holes = 0;                ///< connected groups of boundary edges
    std::size_t flippedEdges = 0;         ///< whose two triangles disagree about front and back
    std::size_t components = 0;           ///< parts that share no vertex
    std::size_t unreferencedVertices = 0; ///< that no triangle uses
    bool hasNormals = false;
    bool hasUvs = false;

    /// Every edge has two triangles that agree: the mesh has an inside.
    bool closed() const {
        return triangles > 0 && nonManifoldEdges == 0 && boundaryEdges == 0 && flippedEdges == 0;
    }
    bool operator==(const MeshHealth&) const = default;
};

/// Linear in the size of the mesh but for the sorting of each vertex' edges; about 0.2 s for a million
/// triangles. Fails only when cancelled. Thread: any but real time.
Result<MeshHealth> healthOf(const TriangleSoup& soup, const Progress& progress = {});

/// What collapseFlatTriangles() did.
struct CollapsedTriangles {
    std::size_t toSegments = 0;
    std::size_t toPoints = 0;
};

/// Turns triangles whose corners lie on one line (height below 1e-12 of the longest side) into the segment
/// they cover, and those whose corners lie at one place into a point: what the closed forms of triangle.h
/// can divide by. The shape stays, no triangle is removed; slivers are left alone.
/// Stops where it is when cancelled.
CollapsedTriangles collapseFlatTriangles(TriangleSoup& soup, const Progress& progress = {});

} // namespace tactum
