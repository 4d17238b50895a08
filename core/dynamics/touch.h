// Where two convex bodies touch, or nearly so: at most four places. For this folder.
#pragma once

#include <array>

#include "core/base/inplace_vector.h"
#include "core/dynamics/convex.h"

namespace tactum {

struct TouchPoint {
    Vec3 point = Vec3::Zero();   ///< halfway between the two surfaces, m, world frame
    Vec3 normal = Vec3::UnitY(); ///< from a to b
    double gap = 0;              ///< m; below 0 they overlap
};

inline constexpr std::size_t kMaxTouchPoints = 4;
using TouchPoints = InplaceVector<TouchPoint, kMaxTouchPoints>;

/// Adds a place where there is room and it is near enough; `onA`: on the surface of a.
inline void keep(TouchPoints& points, const Vec3& onA, const Vec3& normal, double gap,
                 double margin) noexcept {
    if (gap <= margin && points.size() < kMaxTouchPoints)
        points.push({onA + 0.5 * gap * normal, normal, gap});
}
/// As b sees a.
inline TouchPoints reversed(TouchPoints points) noexcept {
    for (TouchPoint& point : points.all())
        point.normal = -point.normal;
    return points;
}

/// Room for the corners of the two bodies that are compared. Thread: one at a time.
struct TouchScratch {
    std::vector<Vec3> a, b; ///< corners, world frame; as long as the largest body has corners
    std::vector<Vec3> normalsA, normalsB;
    std::vector<Vec3> polygon, other; ///< with room for two faces
    /// For all pairs among these bodies.
    void reserve(std::size_t corners, std::size_t faces) {
        a.resize(corners), b.resize(corners);
        normalsA.resize(faces), normalsB.resize(faces);
        polygon.reserve(2 * corners + 8), other.reserve(2 * corners + 8);
    }
};

/// The places that are no more than `margin` apart. Faces are found by separating axes, exactly; of two that
/// overlap the least way out counts. Source: S. Gottschalk and others, OBBTree, SIGGRAPH 1996 (the axes of
/// boxes); I. Sutherland and G. Hodgman, Reentrant polygon clipping, 1974. Thread: real time.
TouchPoints touchPoints(const Convex& a, const Pose& a_W, const Convex& b, const Pose& b_W, double margin,
                        TouchScratch& scratch) noexcept;

} // namespace tactum
