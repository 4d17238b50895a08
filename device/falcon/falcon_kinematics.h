// The Falcon's arm: where the grip is from the angles of its legs, and what its motors do for a force.
//
// Frame D here: origin in the middle of the way from all in to all out, 125 mm in front of the middle of the
// base; x right, y up, z toward the person; metres. Angles are of the thighs, in radians, in the order of
// FalconLegs. The model is that of R. E. Stamper's thesis (Maryland 1997) with the sideways offsets that the
// Falcon has; its lengths were measured by users and may be wrong by a millimetre.
// Thread: real time.
#pragma once

#include <optional>

#include "core/base/vec.h"
#include "device/falcon/falcon_packet.h"

namespace tactum {

/// Of the origin of D above the base plane. Unit: m.
inline constexpr double kFalconCentre = 0.125;

struct FalconArm {
    Vec3 angles = Vec3::Zero();
    Mat3 jacobian = Mat3::Zero(); ///< how the angles change with the position, rad/m; a row for each leg
};

/// The arm that holds the grip there; nullopt out of reach, and for what is no number.
std::optional<FalconArm> falconArmAt(const Vec3& position) noexcept;

/// The place of the grip by Newton's method, from a place nearby: the last one, or the origin. nullopt: no
/// place has these angles, or none was found.
std::optional<Vec3> falconPosition(const Vec3& angles, const Vec3& nearby) noexcept;

Vec3 falconAngles(const FalconLegs& counts) noexcept;

struct FalconMotorSettings {
    double countsPerTorque = 10000; ///< motor command for 1 N m at a leg
    double maxForce = 8;            ///< N
};

/// The motor commands that push the grip with `force`, N. What is too much for the force's limit or for one
/// motor is scaled as a whole, so that the direction stays. Zero for what is no number.
FalconLegs falconMotors(const Mat3& jacobian, const Vec3& force,
                        const FalconMotorSettings& settings) noexcept;

} // namespace tactum
