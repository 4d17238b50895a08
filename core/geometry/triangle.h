// One triangle against a point and against a moving sphere: exact closed forms.
#pragma once

#include "core/base/vec.h"

namespace tactum {

/// Corners in the order of the file; the front side sees them counter-clockwise. A segment repeats its
/// last corner, a point repeats it twice: every function here takes them too.
struct Triangle {
    Vec3 a, b, c;
};

/// Which part of a triangle a closest point lies on.
enum class Feature : unsigned char { Face, Edge, Vertex };

/// The point of a triangle nearest to some point, with what shading and texture need of it.
struct ClosestPoint {
    Vec3 point;   ///< frame and unit of the triangle
    Vec3 weights; ///< barycentric: point = weights[0] a + weights[1] b + weights[2] c; sum 1
    Feature feature = Feature::Face;
};

/// Thread: real time. Cost: about 60 multiplications. Source: Voronoi regions of the triangle.
ClosestPoint closestPoint(const Triangle& triangle, const Vec3& p) noexcept;

/// The foot of p on the plane of the triangle, which may lie outside of it: some weights are negative then. A
/// triangle without a plane has none: the closest point instead. Thread: real time.
ClosestPoint footOnPlane(const Triangle& triangle, const Vec3& p) noexcept;

/// When a sphere of radius r, whose centre moves from p to p + d, first touches the triangle: the smallest
/// t in [0, 1] at which the distance is r and falling. `kNoContact` if there is none. A sphere that
/// overlaps already gives 0 when the move goes deeper and kNoContact when it leads out: the distance to a
/// convex set along a line is a convex function of t.
/// Thread: real time.
/// Contacts after `until` may be reported as none.
double sweepSphere(const Triangle& triangle, const Vec3& p, const Vec3& d, double r,
                   double until = 1) noexcept;

inline constexpr double kNoContact = 2.0;

} // namespace tactum
