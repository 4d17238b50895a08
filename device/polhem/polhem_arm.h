// The mechanics of a Polhem: from encoder counts to a place, from a force to motor currents.
//
// A column turns about the vertical (a). On it, in one upright plane, turn the upper arm (b) and a crank (c),
// both counted from straight ahead upwards. The forearm is a lever on the upper arm's end: its long side
// carries the finger, its short one is held by a rod from the crank. Lengths, masses, gears and motors:
// forsslund/hfabapi, hfab_polhem.h and polhem_v3() in hfab_math.h, 2026-06.
//
// Frame D, metres: x right, y up, z toward the person; its origin is the middle of the workspace.
#pragma once

#include <array>
#include <optional>

#include "core/base/vec.h"

namespace tactum {

struct PolhemArm {
    double apart = 0.034;                   ///< m, from the crank's axis to the upper arm's, ahead of it
    double upperArm = 0.165;                ///< m
    double forearm = 0.1308, lever = 0.034; ///< m, from its pivot to the finger, and to the rod
    double crank = 0.025, rod = 0.190;      ///< m
    Vec3 origin{0, 0.0325, 0.2045};         ///< m, of the workspace, from between the two axes

    /// Of upper arm, crank, rod, forearm: kg, and where its middle is, m along it from its inner end and
    /// aside.
    struct Body {
        double mass, along, aside;
    };
    std::array<Body, 4> bodies{{{0.15764, 0.030123, 0.000484},
                                {0.07733, -0.004086, 0.001911},
                                {0.09767, 0.087765, 0.001978},
                                {0.11265, 0.061701, 0.000576}}};

    Vec3 gear{0.0288534 / 0.175, -0.0136981 / 0.1, 0.0137281 / 0.1}; ///< rad of a joint for one of its motor
    Vec3 torqueConstant{0.0603, 0.0538, 0.0538};                     ///< N m/A
    double countsPerTurn = 4096;                                     ///< of a motor
    std::array<int, 3> rest{8312, -10366, 19764}; ///< counts that those of the rest position are called
    std::array<int, 3> wristRest{0, 30, 0};       ///< likewise
    double wristCountsPerTurn = 1024;
    double maxCurrent = 3; ///< A, the current that the maker's figures name for a motor
};

// Joints are (a, b, c) in rad. Thread: real time.

/// `encoders`: counted from the rest position.
Vec3 jointsOf(const PolhemArm& arm, const std::array<int, 6>& encoders) noexcept;
/// How the handle is turned, from its own axes to D: z goes along the stylus, from its tip, and is the
/// forearm's direction while the wrist is straight. `column`: the joint a; `forearm`: its direction, from
/// straight ahead upwards; `wrist`: turned about the forearm, bent, turned about the stylus. All in rad.
Quat turnOf(double column, double forearm, const Vec3& wrist) noexcept;
/// The forearm's direction at such joints; NaN where the rod would not reach.
double forearmOf(const PolhemArm& arm, const Vec3& joints) noexcept;
/// `encoders`: counted from the rest position.
Vec3 wristOf(const PolhemArm& arm, const std::array<int, 6>& encoders) noexcept;

/// nullopt where the rod would not reach.
std::optional<Vec3> positionOf(const PolhemArm& arm, const Vec3& joints) noexcept;
/// A, of the motors: what holds the arm's own weight, and what is left of the motors for a force on the
/// finger in N, in the same direction; none where the joints are none or the force is no number.
Vec3 currentsFor(const PolhemArm& arm, const Vec3& force, const Vec3& joints) noexcept;

} // namespace tactum
