// The master form of a mesh: indexed polygons as they came, cut into triangles, nothing assumed.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/vec.h"

namespace tactum {

using Index = std::uint32_t;

/// Triangles of any kind: open, non-manifold, intersecting, unconnected. Immutable once built: scenes,
/// their undo history and compiled worlds share one soup through a shared_ptr to const.
/// A triangle whose last two corners are equal is a segment, one whose three corners are equal a point.
/// Unit: metre, body frame. Every index is smaller than positions.size(), every coordinate finite.
struct TriangleSoup {
    std::vector<Vec3> positions;
    std::vector<std::array<Index, 3>> triangles;
    /// Which surface of the object a triangle belongs to; same length as triangles.
    std::vector<Index> surfaceOf;
    /// Per corner, three to a triangle; empty when the file has none. Unit length.
    std::vector<Eigen::Vector3f> cornerNormals;
    /// Per corner, three to a triangle; empty when the file has none.
    std::vector<Eigen::Vector2f> cornerUvs;

    bool operator==(const TriangleSoup&) const = default;
};

/// An axis-aligned box; empty until something is added. Unit and frame of what was added.
struct Bounds {
    Vec3 low = Vec3::Constant(1e300);
    Vec3 high = Vec3::Constant(-1e300);

    void add(const Vec3& p) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    bool empty() const { return low.x() > high.x(); }
    Vec3 centre() const { return 0.5 * (low + high); }
    double diagonal() const { return empty() ? 0.0 : (high - low).norm(); }
};

/// The box of every corner that a triangle uses (unused positions do not count).
Bounds boundsOf(const TriangleSoup& soup);

/// Whether two soups differ at most in their surfaces and texture coordinates: hierarchies and normals of one
/// are those of the other. Some milliseconds for a million triangles.
bool haveSameShape(const TriangleSoup& a, const TriangleSoup& b);

} // namespace tactum
