// A triangle soup as the vertices and index lists that a renderer draws, and what these cannot say.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/triangle_soup.h"

namespace tactum {

/// The elements of one surface and kind.
struct DrawnPart {
    Index surface = 0;
    int corners = 3; ///< to an element: 3 triangles, 2 segments, 1 points
    std::vector<std::uint32_t> vertices;
};

/// Vertices in single precision: first one for each position of the soup, then one for every corner that has
/// another normal or texture coordinate at its position. Parts by surface, then by kind.
struct DrawnMesh {
    std::vector<Eigen::Vector3f> positions, normals; ///< no normals where the soup has none
    std::vector<Eigen::Vector2f> uvs;                ///< v counts downward, as in glTF
    std::vector<DrawnPart> parts;

    std::vector<Index> copies; ///< the position of each vertex beyond the soup's positions
    std::vector<Index> order;  ///< the soup's triangle of each drawn one; empty when they are the same
    bool positionsAreExact = true, uvsAreExact = true; ///< whether single precision lost nothing
    std::vector<Eigen::Vector2f> trueUvs;              ///< v upward, as in the soup
};

/// Thread: any but real time.
DrawnMesh drawn(const TriangleSoup& soup, std::size_t surfaces);

} // namespace tactum
