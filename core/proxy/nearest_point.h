// The update stage's minimisation (section 2.2): the point of a polyhedron nearest to the finger.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/base/vec.h"

namespace tactum {

inline constexpr int kMaxPlanes = 32;

/// A half-space normal . x >= offset. normal is of unit length and points out of the surface toward the
/// proxy. The origin is where the caller chose it (the proxy, in the update).
struct ConstraintPlane {
    Vec3 normal = Vec3::UnitZ();
    double offset = 0; ///< metre
};

struct NearestPoint {
    Vec3 x = Vec3::Zero();                   ///< the solution of equation (2)
    std::array<double, kMaxPlanes> lambda{}; ///< multipliers, >= 0: x - u = sum lambda_i normal_i (6)
    int active = 0;                          ///< how many multipliers are positive: at most three
    bool feasible = true;                    ///< false: the planes exclude each other, x is the origin
};

/// Minimises |x - u| subject to every plane (equation 2).
/// At most kMaxPlanes planes; exact to rounding, also for parallel, opposite and repeated normals.
/// The force on plane i for a spring k is k lambda_i normal_i (equation 19).
/// Thread: real time; at most a few dozen pivots, each linear in the number of planes.
NearestPoint nearestPoint(const Vec3& u, std::span<const ConstraintPlane> planes) noexcept;

/// The same with an answer always. Squeezed between planes that leave less room than the proxy needs, no
/// plane lets it deeper, and none insists on its full radius, so that it can still slide and leave: offsets
/// above 0 are then set to 0, and `feasible` is false. Thread: real time.
NearestPoint nearestReachable(const Vec3& u, std::span<ConstraintPlane> planes) noexcept;

} // namespace tactum
