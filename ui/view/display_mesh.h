// A soup as a graphics card likes it: indexed vertices with normals, triangles sorted by surface.
#pragma once

#include <array>
#include <vector>

#include "core/base/progress.h"
#include "core/geometry/triangle_soup.h"

namespace tactum {

/// Corners of one surface's parts, as vertex numbers.
struct DisplaySurface {
    std::vector<int> triangles; ///< three each
    std::vector<int> segments;  ///< two each
    std::vector<int> points;    ///< one each
};

struct DisplayMesh {
    std::vector<float> positions;            ///< x, y, z of each vertex; metre, body frame
    std::vector<float> normals;              ///< as positions; empty: shade each triangle flat
    std::vector<std::array<int, 3>> corners; ///< vertices of each triangle of the soup, in its order
};

/// Who changes surfaces alone keeps the vertices. Thread: any but real time.
std::vector<DisplaySurface> bySurface(const std::vector<std::array<int, 3>>& corners,
                                      const std::vector<Index>& surfaceOf, std::size_t surfaceCount);

/// Vertices are the soup's positions; no normals. Quick. Thread: any but real time.
DisplayMesh flatMesh(const TriangleSoup& soup);

/// A vertex for each normal at a position: the file's normals, or, where it has none, normals that are
/// smooth over edges that bend less than 50 degrees. Seconds for a million triangles. Cancelled work gives
/// a flat mesh. Thread: any but real time.
DisplayMesh smoothMesh(const TriangleSoup& soup, const Progress& progress = {});

} // namespace tactum
