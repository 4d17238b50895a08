#include "core/dynamics/measure.h"

#include <algorithm>
#include <cmath>

namespace tactum {

namespace {

Vec3 axisOf(const Pose& frame, int axis) noexcept {
    return frame.rotation * Vec3::Unit(axis);
}

/// Along a force at the origin of b; where there is no direction any will do.
Measured pushAlong(double value, const Vec3& way, const Pose& b_W) noexcept {
    return {value, {way, b_W.translation, Vec3::Zero()}};
}

Measured turning(double value, const Vec3& axis_W) noexcept {
    return {value, {Vec3::Zero(), Vec3::Zero(), axis_W}};
}

Vec3 unitOr(const Vec3& v, const Vec3& otherwise) noexcept {
    const double length = v.norm();
    return length > 1e-12 ? Vec3(v / length) : otherwise;
}

/// The quaternion from a to b of the shorter turn.
Quat between(const Pose& a_W, const Pose& b_W) noexcept {
    Quat q = a_W.rotation.conjugate() * b_W.rotation;
    if (q.w() < 0) q.coeffs() = -q.coeffs();
    return q;
}

/// Half of a turn of at most half a turn round: the same frame from either side.
Quat halfOf(const Quat& turn) noexcept {
    return Quat(turn.coeffs() + Quat::Identity().coeffs()).normalized();
}

// With q' = w q / 2 the angle 2 atan2(q_i, q_w) grows as this says, frame a.
Measured twist(const Coordinate& of, const Pose& a_W, const Pose& b_W) noexcept {
    const Quat q = between(a_W, b_W);
    const int i = of.axis, j = (i + 1) % 3, k = (i + 2) % 3;
    const Vec3 v = q.vec();
    const double square = q.w() * q.w() + v[i] * v[i];
    Vec3 gradient = Vec3::Unit(i);
    if (square > 1e-12) {
        gradient[j] = (q.w() * v[k] + v[i] * v[j]) / square;
        gradient[k] = (v[i] * v[k] - q.w() * v[j]) / square;
    }
    return turning(2 * std::atan2(v[i], q.w()), a_W.rotation * gradient);
}

} // namespace

Measured measure(const Coordinate& of, const Pose& a_W, const Pose& b_W) noexcept {
    const Vec3 apart = b_W.translation - a_W.translation;
    const Vec3 axis = axisOf(a_W, of.axis);
    switch (of.measure) {
    case Measure::Along:
        return pushAlong(axis.dot(apart), axis, b_W);
    case Measure::Aside: {
        const Vec3 aside = apart - axis.dot(apart) * axis;
        return pushAlong(aside.norm(), unitOr(aside, axisOf(a_W, (of.axis + 1) % 3)), b_W);
    }
    case Measure::Distance:
        return pushAlong(apart.norm(), unitOr(apart, axisOf(a_W, 0)), b_W);
    case Measure::Twist:
        return twist(of, a_W, b_W);
    case Measure::Spin:
        return turning(twist(of, a_W, b_W).value,
                       a_W.rotation * (halfOf(between(a_W, b_W)) * Vec3::Unit(of.axis)));
    case Measure::Cone: {
        const Vec3 other = axisOf(b_W, of.axis), normal = axis.cross(other);
        return turning(std::atan2(normal.norm(), axis.dot(other)),
                       unitOr(normal, axisOf(a_W, (of.axis + 1) % 3)));
    }
    case Measure::Turned: {
        const Quat q = between(a_W, b_W);
        const double sine = q.vec().norm();
        return turning(2 * std::atan2(sine, q.w()), a_W.rotation * unitOr(q.vec(), Vec3::UnitX()));
    }
    case Measure::Tilt: {
        const Vec3 other = axisOf(b_W, of.axis2);
        return turning(axis.dot(other), other.cross(axis));
    }
    case Measure::Way:
        return pushAlong(0, axisOf(b_W, of.axis), b_W);
    case Measure::Residue: {
        const Quat q = between(a_W, b_W);
        const Vec3 unit = Vec3::Unit(of.axis);
        return turning(2 * q.vec()[of.axis], a_W.rotation * Vec3(q.w() * unit + Vec3(q.vec()).cross(unit)));
    }
    }
    return {};
}

Wrench rateOf(const Coordinate& of, const Pose& a_W, const Pose& b_W, const FrameVelocity& a,
              const FrameVelocity& b) noexcept {
    const Vec3 axis = axisOf(a_W, of.axis), turned = a.angular.cross(axis);
    Wrench rate;
    if (of.measure == Measure::Along) { // its point moves too: p' x f is a torque
        rate.force = turned;
        rate.point = b_W.translation;
        rate.torque = b.linear.cross(axis);
    } else if (of.measure == Measure::Tilt) {
        const Vec3 other = axisOf(b_W, of.axis2);
        rate.torque = b.angular.cross(other).cross(axis) + other.cross(turned);
    } else { // Residue: what is locked turns with a
        rate.torque = a.angular.cross(measure(of, a_W, b_W).along.torque);
    }
    return rate;
}

Pose ahead(const Pose& frame, const FrameVelocity& moves, double dt) noexcept {
    const double angle = moves.angular.norm() * dt;
    const Quat turn =
        angle > 0 ? Quat(Eigen::AngleAxisd(angle, moves.angular.normalized())) : Quat::Identity();
    return {turn * frame.rotation, frame.translation + dt * moves.linear};
}

} // namespace tactum
