// Spatial vectors: the motion of a rigid body and the forces on it as six numbers, the angular three first.
// All are seen from one point, the origin of the tree that the body belongs to, along the axes of the world.
// Source: R. Featherstone, Rigid Body Dynamics Algorithms, Springer 2008, chapter 2.
#pragma once

#include "core/base/vec.h"

namespace tactum {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

inline Vec6 spatial(const Vec3& angular, const Vec3& linear) noexcept {
    Vec6 both; // number by number: g++ makes a loop of a comma initializer
    for (int i = 0; i < 3; ++i) {
        both[i] = angular[i];
        both[3 + i] = linear[i];
    }
    return both;
}
/// The same, where it is to be kept: what has been written by three and is read by two waits until it is in
/// the cache: a third of all that a link cost.
template <typename Six> void putHalves(const Vec3& angular, const Vec3& linear, Six&& to) noexcept {
    to.template head<3>() = angular;
    to.template tail<3>() = linear;
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
/// The velocity of the material point of a body that is at `point`, m/s.
inline Vec3 velocityAt(const Vec6& v, const Vec3& point) noexcept {
    return linear(v) + angular(v).cross(point);
}

/// The inertia of a rigid body of `mass` about the origin: `arm` is its mass times where its centre is,
/// `about` its moments there (2.63).
inline void setInertia(double mass, const Vec3& arm, const Mat3& about, Mat6& inertia) noexcept {
    for (int i = 0; i < 3; ++i) { // number by number: see putHalves()
        const int j = i == 2 ? 0 : i + 1, k = i == 0 ? 2 : i - 1;
        for (int row = 0; row < 3; ++row) {
            inertia(row, i) = about(row, i);
            inertia(3 + row, 3 + i) = row == i ? mass : 0;
        }
        inertia(i, 3 + i) = inertia(3 + i, i) = 0;
        inertia(k, 3 + i) = inertia(3 + i, k) = -arm[j];
        inertia(j, 3 + i) = inertia(3 + i, j) = arm[k];
    }
}

} // namespace tactum
