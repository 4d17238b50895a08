// A mesh as convex shapes, for what bodies meet.
#pragma once

#include <vector>

#include "core/dynamics/collider.h"
#include "core/geometry/triangle_soup.h"

namespace tactum {

/// Of more parts than this a mesh counts as one.
inline constexpr std::size_t kMostParts = 32;
/// Points of one hull: of more, the farthest along as many directions.
inline constexpr std::size_t kMostHullPoints = 64;

/// The hull of each part that shares no corner with the others; parts that are flat are left out unless all
/// are. In the order of their first triangles. Thread: any but real time.
std::vector<ColliderShape> convexParts(const TriangleSoup& soup);

} // namespace tactum
