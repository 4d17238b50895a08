// Vectors and rigid poses. SI units; a point's suffix names its frame: p_W world, p_B body, p_D device.
#pragma once

#include <cmath>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace tactum {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;

/// q v q* for a q of unit length: what Eigen computes, bit for bit, where the compiler can see it. (Eigen's
/// own stays a call of its own at -O2, and a step of the proxy has dozens.)
inline Vec3 rotated(const Quat& q, const Vec3& v) {
    const double x = q.x(), y = q.y(), z = q.z(), w = q.w();
    const double a = 2 * (y * v.z() - z * v.y()), b = 2 * (z * v.x() - x * v.z()),
                 c = 2 * (x * v.y() - y * v.x());
    return {v.x() + w * a + (y * c - z * b), v.y() + w * b + (z * a - x * c),
            v.z() + w * c + (x * b - y * a)};
}

/// A rigid motion X_AB: p_A = rotation * p_B + translation. Translation in metres.
struct Pose {
    Quat rotation = Quat::Identity();
    Vec3 translation = Vec3::Zero();

    Vec3 apply(const Vec3& p) const { return rotated(rotation, p) + translation; }
    Vec3 applyInverse(const Vec3& p) const { return rotated(rotation.conjugate(), p - translation); }
    Vec3 rotate(const Vec3& v) const { return rotated(rotation, v); }
    Vec3 rotateInverse(const Vec3& v) const { return rotated(rotation.conjugate(), v); }

    /// X_BA.
    Pose inverse() const { return {rotation.conjugate(), rotation.conjugate() * -translation}; }
    /// X_AC = X_AB * X_BC.
    Pose operator*(const Pose& other) const { return {rotation * other.rotation, apply(other.translation)}; }

    bool operator==(const Pose& other) const {
        return rotation.coeffs() == other.rotation.coeffs() && translation == other.translation;
    }
};

/// The rotation of a quaternion of any length but 0. One that has unit length but for rounding keeps its
/// bits, so that writing and reading it changes nothing.
inline Quat unitLength(const Quat& q) {
    return std::abs(q.norm() - 1) <= 1e-12 ? q : q.normalized();
}

/// The shortest turn that takes one direction to another, both of any length but 0; opposite ones go round
/// about some axis across. (Eigen's FromTwoVectors asks a singular value decomposition for that axis, and
/// each source for seconds to compile it.)
inline Quat turnOnto(const Vec3& from, const Vec3& to) {
    const Vec3 a = from.normalized(), b = to.normalized();
    Quat turn(0.5 * (a + b).squaredNorm(), 0, 0, 0); // times |a + b|, twice the cosine of half the angle
    turn.vec() = a.cross(b);
    return turn.norm() < 1e-9 ? Quat(Eigen::AngleAxisd(EIGEN_PI, a.unitOrthogonal())) : turn.normalized();
}

} // namespace tactum
