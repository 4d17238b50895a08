// Static, dynamic and viscous friction as a bound on how far the proxy may slide (sections 4.1 and 4.2).
#pragma once

#include "core/surface/material.h"

namespace tactum {

/// What one contact plane allows. Lengths, because force = stiffness x length: the spring cancels.
struct FrictionLimit {
    double coefficient = 0; ///< mu_s while the contact sticks, mu_d while it slips
    double viscosity = 0;   ///< b / k, in s; 0 while the contact sticks
};

/// The limit that a contact in the given state obeys. Thread: real time.
inline FrictionLimit frictionLimit(const Material& material, bool slipping) noexcept {
    if (!slipping) return {material.staticFriction, 0};
    return {material.dynamicFriction, material.viscosity / material.stiffness};
}

/// How far the proxy may slide in a time. `excess`: distance from the proxy to where it would go without
/// friction, i.e. tangential force / k. `depth`: normal force / k, the multiplier of the plane. Unit: m, s.
/// Equation (21) as magnitudes along the slip direction, b e' = -k (e - mu depth), solved exactly over dt:
/// never overshoots, and for b = 0 ends on the edge of the cone. 0 means that the contact holds.
/// Thread: real time.
double allowedSlide(const FrictionLimit& limit, double excess, double depth, double dt) noexcept;

/// Inverse of allowedSlide: the time that it takes to slide by `distance`, at most the time in which
/// allowedSlide reaches it; 0 for a contact without viscosity. Unit: s. Thread: real time.
double slideTime(const FrictionLimit& limit, double excess, double depth, double distance) noexcept;

} // namespace tactum
