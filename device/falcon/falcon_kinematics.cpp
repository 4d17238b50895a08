#include "device/falcon/falcon_kinematics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tactum {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

// Lengths in m, names as in the thesis.
constexpr double kThigh = 0.060;                          // a: motor axis to knee
constexpr double kShin = 0.1025;                          // b: long side of the parallelogram
constexpr double kShinEnds = 0.01125 + 0.01125;           // d + e: its short links
constexpr double kGripOut = 0.01443, kGripSide = -0.025;  // c, f: the shin's joint from the grip's centre
constexpr double kBaseOut = 0.0400, kBaseSide = -0.02309; // r, s: the motor's axis from the middle
constexpr double kAzimuths[3] = {105 * kDegree, -15 * kDegree, -135 * kDegree};

// Encoder: 320 slots read four times each; the capstan drives 110 by 14.25.
constexpr double kAngleAtZero = 35 * kDegree;
constexpr double kAnglePerCount = 14.25 / 110 * 360 / (4 * 320) * kDegree;

/// A cosine or its square may leave its range: the arm does not reach.
bool isProper(double cosine) noexcept {
    return std::abs(cosine) < 1;
}

struct Leg {
    double angle = 0;
    Vec3 row = Vec3::Zero(); ///< d angle / d position
};

/// `p`: from the middle of the base. The loop equations of one leg, whose plane stands at `azimuth`:
///   side + f = b cos(sway);   length = d + e + b sin(sway)
///   out + c = a cos(angle) + length cos(shin);   z = a sin(angle) + length sin(shin)
std::optional<Leg> legAt(const Vec3& p, double azimuth) noexcept {
    const double ca = std::cos(azimuth), sa = std::sin(azimuth);
    const double out = p.x() * ca + p.y() * sa - kBaseOut + kGripOut;
    const double cosSway = (-p.x() * sa + p.y() * ca - kBaseSide + kGripSide) / kShin;
    if (!isProper(cosSway)) return std::nullopt;
    const double sinSway = std::sqrt(1 - cosSway * cosSway);
    const double length = kShinEnds + kShin * sinSway;
    const double reach = std::hypot(out, p.z());
    const double cosKnee = (reach * reach + kThigh * kThigh - length * length) / (2 * kThigh * reach);
    if (!isProper(cosKnee)) return std::nullopt;
    // The other angle, with a plus, folds the knee the wrong way.
    const double angle = std::atan2(p.z(), out) - std::acos(cosKnee);
    const double shin = std::atan2(p.z() - kThigh * std::sin(angle), out - kThigh * std::cos(angle));
    const double across = kThigh * sinSway * std::sin(shin - angle);
    if (std::abs(across) < 1e-9 * kThigh) return std::nullopt; // thigh and shin in one line
    const double cs = std::cos(shin), ss = std::sin(shin);
    return Leg{angle, Vec3(cs * sinSway * ca - cosSway * sa, cs * sinSway * sa + cosSway * ca, ss * sinSway) /
                          across};
}

double worst(const Vec3& v) noexcept {
    return v.cwiseAbs().maxCoeff();
}

} // namespace

std::optional<FalconArm> falconArmAt(const Vec3& position) noexcept {
    if (!position.allFinite()) return std::nullopt;
    const Vec3 p = position + Vec3(0, 0, kFalconCentre);
    FalconArm arm;
    for (int i = 0; i < 3; ++i) {
        const std::optional<Leg> leg = legAt(p, kAzimuths[i]);
        if (!leg) return std::nullopt;
        arm.angles[i] = leg->angle;
        arm.jacobian.row(i) = leg->row;
    }
    return arm;
}

std::optional<Vec3> falconPosition(const Vec3& angles, const Vec3& nearby) noexcept {
    constexpr double kExact = 1e-12; // rad
    constexpr int kMaxTries = 40;    // four are usual
    if (!angles.allFinite()) return std::nullopt;
    Vec3 p = nearby;
    std::optional<FalconArm> arm = falconArmAt(p);
    if (!arm) arm = falconArmAt(p = Vec3::Zero());
    double part = 1; // of Newton's step
    for (int i = 0; i < kMaxTries; ++i) {
        const Vec3 missing = angles - arm->angles;
        if (worst(missing) < kExact) return p;
        const Vec3 next = p + part * (arm->jacobian.inverse() * missing);
        const std::optional<FalconArm> there = falconArmAt(next);
        // A step that leaves the reach or leads away was too long.
        if (!there || !(worst(angles - there->angles) < worst(missing))) {
            part *= 0.5;
            continue;
        }
        p = next;
        arm = there;
        part = std::min(1.0, 2 * part);
    }
    return std::nullopt;
}

Vec3 falconAngles(const FalconLegs& counts) noexcept {
    return Vec3::Constant(kAngleAtZero) + kAnglePerCount * Vec3(counts[0], counts[1], counts[2]);
}

FalconLegs falconMotors(const Mat3& jacobian, const Vec3& force,
                        const FalconMotorSettings& settings) noexcept {
    const double size = force.norm();
    const double scale = size > settings.maxForce ? settings.maxForce / size : 1;
    // Work is the same at the grip and at the legs: torque = (dp/dangle)^T force. A motor's positive
    // direction is the one in which the angle becomes smaller.
    Vec3 motors = -settings.countsPerTorque * scale * (jacobian.inverse().transpose() * force);
    if (!motors.allFinite()) return {};
    const double most = worst(motors);
    if (most > kFalconMostMotor) motors *= kFalconMostMotor / most;
    FalconLegs rounded;
    for (int i = 0; i < 3; ++i)
        rounded[std::size_t(i)] = std::int16_t(std::lround(motors[i]));
    return rounded;
}

} // namespace tactum
