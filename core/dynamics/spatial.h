// Spatial vectors: the motion of a rigid body and the forces on it as six numbers, the angular three first.
// All are seen from one point, the origin of the tree that the body belongs to, along the axes of the world.
// Source: R. Featherstone, Rigid Body Dynamics Algorithms, Springer 2008, chapter 2.
#pragma once

#include "core/base/vec.h"

namespace tactum {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

inline Vec6 spatial(const Vec3& angular, const Vec3& linear) noexcept {
    Vec6 both; // by halves: g++ makes a loop of a comma initializer
    both.head<3>() = angular;
    both.tail<3>() = linear;
    return both;
}
inline Vec3 angular(const Vec6& v) noexcept {
    return v.head<3>();
}
inline Vec3 linear(const Vec6& v) noexcept {
    return v.tail<3>();
}

/// A turn of 1 rad/s about an axis through a point.
inline Vec6 turnAbout(const Vec3& axis, const Vec3& point) noexcept {
    return spatial(axis, point.cross(axis));
}
/// A force that acts at a point.
inline Vec6 forceAt(const Vec3& force, const Vec3& point) noexcept {
    return spatial(point.cross(force), force);
}
/// The velocity of the material point of a body that is at `point`, m/s.
inline Vec3 velocityAt(const Vec6& v, const Vec3& point) noexcept {
    return linear(v) + angular(v).cross(point);
}

/// How a motion m that is fixed to something that moves with v changes: v x m (2.31).
inline Vec6 crossMotion(const Vec6& v, const Vec6& m) noexcept {
    return spatial(angular(v).cross(angular(m)), angular(v).cross(linear(m)) + linear(v).cross(angular(m)));
}
/// How a force f that is fixed to something that moves with v changes: v x* f (2.32).
inline Vec6 crossForce(const Vec6& v, const Vec6& f) noexcept {
    return spatial(angular(v).cross(angular(f)) + linear(v).cross(linear(f)), angular(v).cross(linear(f)));
}

inline Mat3 crossMatrix(const Vec3& v) noexcept {
    Mat3 m;
    m.col(0) = Vec3(0, v.z(), -v.y());
    m.col(1) = Vec3(-v.z(), 0, v.x());
    m.col(2) = Vec3(v.y(), -v.x(), 0);
    return m;
}

/// The inertia of a rigid body of `mass` at `centre` whose moments about its centre are `moments` (2.63).
inline Mat6 spatialInertia(double mass, const Vec3& centre, const Mat3& moments) noexcept {
    const Mat3 arm = mass * crossMatrix(centre);
    Mat6 inertia;
    inertia.topLeftCorner<3, 3>() =
        moments + mass * (centre.squaredNorm() * Mat3::Identity() - centre * centre.transpose());
    inertia.topRightCorner<3, 3>() = arm;
    inertia.bottomLeftCorner<3, 3>() = -arm;
    inertia.bottomRightCorner<3, 3>() = mass * Mat3::Identity();
    return inertia;
}

} // namespace tactum
