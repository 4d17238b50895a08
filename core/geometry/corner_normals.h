// Smooth normals at the corners of triangles: for force shading and for display.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/geometry/triangle_soup.h"

namespace tactum {

/// Normals, three to a triangle in its order: the mean of the triangles around the corner, weighted by their
/// angle there, as far as no edge on the way bends by more than `creaseAngle` (radian). Edges that are not
/// shared by exactly two triangles of one orientation count as creases. Triangles without an area get
/// (0, 0, 1). Corners between the same creases get the same bits. Unit length, body frame.
/// Linear but for the sorting around each vertex; about 0.3 s for a million triangles: for a worker. Fails
/// only when cancelled. Thread: any but real time.
Result<std::vector<Eigen::Vector3f>> cornerNormalsOf(const TriangleSoup& soup, double creaseAngle,
                                                     const Progress& progress = {});

} // namespace tactum
