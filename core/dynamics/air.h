// The air that bodies move through, and how it slows them. For this folder.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "core/dynamics/collider.h"
#include "core/dynamics/place.h"

namespace tactum {

/// What of a body meets the air: the box around its colliders along the axes of the body. Each of its faces
/// is slowed by rho / 2 c_d A v^2 with c_d = 1, and turned as its strips are, which adds up to rho / 64 b
/// (l^4 + m^4) w^2 about the side b. Both act at the middle of the box, along and about its axes. Source: the
/// inertia-box fluid model of MuJoCo (documentation, Computation, Fluid forces) without viscosity; c_d of a
/// cube is 1.05 (S. Hoerner, Fluid-Dynamic Drag, 1965, chapter 3).
struct AirBox {
    Place place;                                         ///< its middle and axes
    Vec3 drag = Vec3::Zero(), turnDrag = Vec3::Zero();   ///< N s^2/m^2, N m s^2: times the speed squared
    Vec3 yield = Vec3::Zero(), turnYield = Vec3::Zero(); ///< 1/kg, 1/(kg m^2): of its body if it were free
    Vec3 swerve =
        Vec3::Zero(); ///< rad/(s^2 N): how a force there would turn it, for it need not be its centre

    /// N along its axes, for a velocity along them in a step of dt: m/s, s. Thread: real time.
    Vec3 force(const Vec3& velocity, double dt) const noexcept {
        return against(velocity, drag, 6 * dt * yield, 4 * dt * dt * swerve);
    }
    /// N m about its axes, for rad/s. Thread: real time.
    Vec3 torque(const Vec3& rate, double dt) const noexcept {
        return against(rate, turnDrag, 6 * dt * turnYield, Vec3::Zero());
    }

private:
    // What would take more than the speed in a step, as the air does of a grain, takes a sixth of it at most:
    // the six together never turn a motion round, whatever joints hold the body, which only make it heavier.
    // Nor does a force turn the body by more than a quarter of a radian in a step: as a vane it would swing
    // up. Where the step can follow the air the fourth power keeps both out of sight: at a thousandth of the
    // speed in a step it is 1e-10 of the force.
    static Vec3 against(const Vec3& rate, const Vec3& drag, const Vec3& slows, const Vec3& turns) noexcept {
        Vec3 force;
        for (int i = 0; i < 3; ++i) {
            const double speed = std::abs(rate[i]), each = drag[i] * speed;
            const double part = each * (slows[i] + turns[i] * speed), square = part * part;
            force[i] = -each * rate[i] / std::sqrt(std::sqrt(1 + square * square));
        }
        return force;
    }
};

/// One for each body that has a collider and is moved by forces; none without air. `places`: of the bodies'
/// frames; `density`: kg/m^3. Thread: any but real time.
std::vector<AirBox> airBoxesOf(std::span<const RigidBody> bodies, std::span<const Place> places,
                               std::span<const Collider> colliders, double density);

} // namespace tactum
