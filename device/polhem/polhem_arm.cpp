#include "device/polhem/polhem_arm.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace tactum {
namespace {

using Vec2 = Eigen::Vector2d;

constexpr double kGravity = 9.81; ///< m/s2
constexpr double kStep = 1e-5;    ///< rad, of differences

Vec2 towards(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

/// What the upright plane holds: ahead and up, m, from between the two axes.
struct Plane {
    Vec2 finger = Vec2::Zero(), forearm = Vec2::Zero(); ///< the second: its direction
    double raised = 0;                                  ///< kg m: the sum of masses by their heights
};

/// The lever's end is where a circle about its pivot meets one about the crank's end; of the two places the
/// one to the right of the way from the pivot to the crank.
std::optional<Plane> planeOf(const PolhemArm& arm, double b, double c) {
    const Vec2 shoulder(arm.apart / 2, 0), axis(-arm.apart / 2, 0);
    const Vec2 elbow = shoulder + arm.upperArm * towards(b), pin = axis + arm.crank * towards(c);
    const Vec2 way = pin - elbow;
    const double far = way.norm();
    const double cosine = (arm.lever * arm.lever + far * far - arm.rod * arm.rod) / (2 * arm.lever * far);
    if (!(std::abs(cosine) <= 1)) return std::nullopt;
    const double lever = std::atan2(way.y(), way.x()) - std::acos(cosine);
    const Vec2 end = elbow + arm.lever * towards(lever), ahead = -towards(lever), rod = (end - pin) / arm.rod;
    Plane plane{.finger = elbow + arm.forearm * ahead, .forearm = ahead};
    const std::array<Vec2, 4> inner{shoulder, axis, pin, elbow}, along{towards(b), towards(c), rod, ahead};
    for (std::size_t i = 0; i < 4; ++i) {
        const PolhemArm::Body& body = arm.bodies[i];
        plane.raised += body.mass * (inner[i].y() + body.along * along[i].y() + body.aside * along[i].x());
    }
    return plane;
}

/// How it changes with one of its angles, a rad.
std::optional<Plane> slope(const PolhemArm& arm, const Vec3& joints, const Vec3& step) {
    const Vec3 more = joints + step, less = joints - step;
    const auto after = planeOf(arm, more[1], more[2]), before = planeOf(arm, less[1], less[2]);
    if (!after || !before) return std::nullopt;
    const double width = 2 * step.norm();
    return Plane{.finger = (after->finger - before->finger) / width,
                 .raised = (after->raised - before->raised) / width};
}

} // namespace

Vec3 jointsOf(const PolhemArm& arm, const std::array<int, 6>& encoders) noexcept {
    Vec3 turned;
    for (std::size_t i = 0; i < 3; ++i)
        turned[Eigen::Index(i)] = double(encoders[i]) + arm.rest[i];
    return (turned * (2 * std::numbers::pi / arm.countsPerTurn)).cwiseProduct(arm.gear);
}

double forearmOf(const PolhemArm& arm, const Vec3& joints) noexcept {
    const auto plane = planeOf(arm, joints[1], joints[2]);
    return plane ? std::atan2(plane->forearm.y(), plane->forearm.x())
                 : std::numeric_limits<double>::quiet_NaN();
}

/// hfab_api.cpp: the first two turn against their encoders.
Vec3 wristOf(const PolhemArm& arm, const std::array<int, 6>& encoders) noexcept {
    Vec3 turned;
    for (std::size_t i = 0; i < 3; ++i)
        turned[Eigen::Index(i)] = double(encoders[3 + i]) + arm.wristRest[i];
    return (turned * (2 * std::numbers::pi / arm.wristCountsPerTurn)).cwiseProduct(Vec3(-1, -1, 1));
}

/// The maker's order of turns, whose x, y and z are z, x and y of D.
Quat turnOf(double column, double forearm, const Vec3& wrist) noexcept {
    using Turn = Eigen::AngleAxisd;
    return Turn(column, Vec3::UnitY()) * Turn(-forearm, Vec3::UnitX()) * Turn(wrist[0], Vec3::UnitZ()) *
           Turn(wrist[1], Vec3::UnitX()) * Turn(wrist[2], Vec3::UnitZ());
}

std::optional<Vec3> positionOf(const PolhemArm& arm, const Vec3& joints) noexcept {
    const auto plane = planeOf(arm, joints[1], joints[2]);
    if (!plane) return std::nullopt;
    const double reach = plane->finger.x();
    return Vec3(std::sin(joints[0]) * reach, plane->finger.y(), std::cos(joints[0]) * reach) - arm.origin;
}

/// No work is lost between finger, joints and motors: torques are the transposed maps of the speeds.
Vec3 currentsFor(const PolhemArm& arm, const Vec3& force, const Vec3& joints) noexcept {
    const auto plane = planeOf(arm, joints[1], joints[2]);
    const auto byB = slope(arm, joints, kStep * Vec3::UnitY()),
               byC = slope(arm, joints, kStep * Vec3::UnitZ());
    if (!force.allFinite() || !plane || !byB || !byC) return Vec3::Zero();
    const Vec3 ahead(std::sin(joints[0]), 0, std::cos(joints[0])), aside(ahead.z(), 0, -ahead.x());
    const auto torqueBy = [&](const Plane& by) {
        return by.finger.x() * force.dot(ahead) + by.finger.y() * force.y();
    };
    const Vec3 pushing(plane->finger.x() * force.dot(aside), torqueBy(*byB), torqueBy(*byC));
    const Vec3 holding = kGravity * Vec3(0, byB->raised, byC->raised);
    const Vec3 perTorque = arm.gear.cwiseQuotient(arm.torqueConstant);
    const Vec3 held = holding.cwiseProduct(perTorque), pushed = pushing.cwiseProduct(perTorque);
    double part = 1;
    for (int i = 0; i < 3; ++i)
        if (const double room = arm.maxCurrent - std::abs(held[i]); std::abs(pushed[i]) > room)
            part = std::min(part, std::max(0.0, room) / std::abs(pushed[i]));
    return (held + part * pushed).cwiseMax(-arm.maxCurrent).cwiseMin(arm.maxCurrent);
}

} // namespace tactum
