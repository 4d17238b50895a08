// The mechanics of WoodenHaptics: from encoder counts to a position, from a force to motor currents.
//
// Three joints in series, after Forsslund, Yip, Sallnas: "WoodenHaptics: A Starting Kit for Crafting
// Force-Reflecting Spatial Haptic Devices" (TEI 2015). A column turns about the vertical (a). On it the upper
// arm leans forward from upright (b). The forearm swings forward from hanging straight down (c); its motor
// stands on the column too and moves it by a linkage, so that c does not change when b does. Each motor
// drives a disc on its body by a rope around a capstan.
//
// Frame D, metres: x right, y up, z toward the person; its origin is the middle of the workspace.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/base/vec.h"

namespace tactum {

struct WoodenArm {
    double column = 0.080;        ///< m, from the table to the joint b
    double upperArm = 0.205;      ///< m
    double forearm = 0.245;       ///< m, to the finger
    Vec3 origin{0, 0.080, 0.220}; ///< m, of the workspace, from the foot of the column

    double capstan = 0.010;         ///< m, diameter, of each motor
    Vec3 disc{0.160, 0.120, 0.120}; ///< m, diameter, of each body
    Vec3 direction{-1, -1, -1};     ///< of a joint when its motor turns forward
    double countsPerTurn = 2000;    ///< of a motor, all four edges
    double torqueConstant = 0.0259; ///< N m/A, of each motor
    double maxCurrent = 2.0;        ///< A; the amplifiers bear no more for long
};

/// The counts of the three motors as the device reports them: they wrap round.
using Counts = std::array<std::int16_t, 3>;

// Joints are (a, b, c) in rad, all 0 in the rest position: upper arm upright, forearm hanging down.
// Thread: real time.

/// `zero`: the counts in the rest position.
Vec3 jointsOf(const WoodenArm& arm, const Counts& counts, const Counts& zero) noexcept;
Vec3 positionOf(const WoodenArm& arm, const Vec3& joints) noexcept;
/// With the elbow up, as it always is; nullopt out of reach.
std::optional<Vec3> jointsAt(const WoodenArm& arm, const Vec3& position) noexcept;
/// m/rad: how the position changes with each joint, a column each.
Mat3 jacobianOf(const WoodenArm& arm, const Vec3& joints) noexcept;
/// A, of the motors, for a force on the finger in N. When one would exceed its limit all three are made less
/// in the same ratio, so that the force keeps its direction; no current for what is no force.
Vec3 currentsFor(const WoodenArm& arm, const Vec3& force, const Vec3& joints) noexcept;

} // namespace tactum
