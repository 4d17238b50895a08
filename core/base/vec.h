// Vectors and rigid poses. SI units; a point's suffix names its frame: p_W world, p_B body, p_D device.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace tactum {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;

/// A rigid motion X_AB: p_A = rotation * p_B + translation. Translation in metres.
struct Pose {
    Quat rotation = Quat::Identity();
    Vec3 translation = Vec3::Zero();

    Vec3 apply(const Vec3& p) const { return rotation * p + translation; }
    Vec3 applyInverse(const Vec3& p) const { return rotation.conjugate() * (p - translation); }
    Vec3 rotate(const Vec3& v) const { return rotation * v; }
    Vec3 rotateInverse(const Vec3& v) const { return rotation.conjugate() * v; }

    /// X_AC = X_AB * X_BC.
    Pose operator*(const Pose& other) const { return {rotation * other.rotation, apply(other.translation)}; }

    bool operator==(const Pose& other) const {
        return rotation.coeffs() == other.rotation.coeffs() && translation == other.translation;
    }
};

} // namespace tactum
