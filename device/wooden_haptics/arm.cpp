#include "device/wooden_haptics/arm.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tactum {

namespace {

/// rad of a joint for one rad of its motor.
Vec3 gearing(const WoodenArm& arm) noexcept {
    return arm.direction.cwiseQuotient(arm.disc) * arm.capstan;
}

/// Modulo 2^16: right as long as less than half of that lies between.
int difference(std::int16_t now, std::int16_t before) noexcept {
    return static_cast<std::int16_t>(static_cast<std::uint16_t>(now) - static_cast<std::uint16_t>(before));
}

} // namespace

Vec3 jointsOf(const WoodenArm& arm, const Counts& counts, const Counts& zero) noexcept {
    const Vec3 turned(difference(counts[0], zero[0]), difference(counts[1], zero[1]),
                      difference(counts[2], zero[2]));
    return (turned * (2 * std::numbers::pi / arm.countsPerTurn)).cwiseProduct(gearing(arm));
}

Vec3 positionOf(const WoodenArm& arm, const Vec3& joints) noexcept {
    const double reach = arm.upperArm * std::sin(joints[1]) + arm.forearm * std::sin(joints[2]);
    const double height = arm.column + arm.upperArm * std::cos(joints[1]) - arm.forearm * std::cos(joints[2]);
    return Vec3(std::sin(joints[0]) * reach, height, std::cos(joints[0]) * reach) - arm.origin;
}

/// Upper arm and forearm are two sides of a triangle; the law of cosines gives the bend of the elbow, which
/// is 0 when they are stretched out.
std::optional<Vec3> jointsAt(const WoodenArm& arm, const Vec3& position) noexcept {
    const Vec3 p = position + arm.origin;
    const double reach = std::hypot(p.x(), p.z()), height = p.y() - arm.column;
    const double b = arm.upperArm, c = arm.forearm;
    const double cosine = (reach * reach + height * height - b * b - c * c) / (2 * b * c);
    if (!(std::abs(cosine) <= 1)) return std::nullopt;
    const double bend = std::acos(cosine);
    const double upper = std::atan2(reach, height) - std::atan2(c * std::sin(bend), b + c * cosine);
    return Vec3(std::atan2(p.x(), p.z()), upper, std::numbers::pi - upper - bend);
}

Mat3 jacobianOf(const WoodenArm& arm, const Vec3& joints) noexcept {
    const Vec3 ahead(std::sin(joints[0]), 0, std::cos(joints[0]));
    const Vec3 aside(std::cos(joints[0]), 0, -std::sin(joints[0]));
    const Vec3 up = Vec3::UnitY();
    const double b = arm.upperArm, c = arm.forearm;
    Mat3 jacobian;
    jacobian << aside * (b * std::sin(joints[1]) + c * std::sin(joints[2])),
        ahead * (b * std::cos(joints[1])) - up * (b * std::sin(joints[1])),
        ahead * (c * std::cos(joints[2])) + up * (c * std::sin(joints[2]));
    return jacobian;
}

Vec3 currentsFor(const WoodenArm& arm, const Vec3& force, const Vec3& joints) noexcept {
    if (!force.allFinite()) return Vec3::Zero();
    // No work is lost between finger, joints and motors: torques are the transposed maps of the speeds.
    const Vec3 joint = jacobianOf(arm, joints).transpose() * force;
    const Vec3 currents = joint.cwiseProduct(gearing(arm)) / arm.torqueConstant;
    const double largest = currents.cwiseAbs().maxCoeff();
    return largest > arm.maxCurrent ? Vec3(currents * (arm.maxCurrent / largest)) : currents;
}

} // namespace tactum
