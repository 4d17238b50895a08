// Static, dynamic and viscous friction as a bound on how far the proxy may slide (sections 4.1 and 4.2).
#pragma once

#include <algorithm>
#include <optional>
#include <span>

#include "core/base/vec.h"
#include "core/surface/material.h"

namespace tactum {

/// What one contact plane allows. Lengths, because force = stiffness x length: the spring cancels.
struct FrictionLimit {
    double coefficient = 0; ///< mu_s while the contact sticks, mu_d while it slips
    double lag = 0;         ///< b / k, in s; 0 while the contact sticks
};

/// The limit that a contact in the given state obeys. Thread: real time.
inline FrictionLimit frictionLimit(const Material& material, bool slipping) noexcept {
    if (!slipping) return {material.staticFriction, 0};
    return {material.dynamicFriction, material.viscosity / material.stiffness};
}

/// Whether anything holds a slide back. Thread: real time.
inline bool hasFriction(const Material& material) noexcept {
    return material.staticFriction > 0 || material.dynamicFriction > 0 || material.viscosity > 0;
}

/// What a plane that pushes with the multiplier `lambda`, in m, along `normal` adds to the depth of the plane
/// `on`: its part along that normal, and nothing across it or against it, so that two halves of a flat floor
/// rub as one. Normals of unit length, in the same frame. The depth of a plane is the sum over all planes, it
/// among them. Thread: real time.
inline double depthShare(double lambda, const Vec3& normal, const Vec3& on) noexcept {
    return std::max(0.0, lambda) * std::max(0.0, normal.dot(on));
}

/// How many times more a plane holds that is felt to lean: the cone of friction stands about the felt normal
/// n', so that up a slope s it takes (s + mu) / (1 - s mu) of the normal force in all, down (mu - s) / (1 + s
/// mu), and across mu (1 + s^2)^(1/2). Of that the slope's own part is in the wish; what is left of the wish
/// at the edge of the cone is mu times this of the depth. `lean`: n' times the plane's normal n; `up`: n'
/// times the unit vector of the slide, negative uphill. At most kMaxSlopeFactor: where s mu comes near
/// to 1 a real stylus would jam, or be lifted over the bump, which a tilted plane does not do. Thread:
/// real time.
double slopeFactor(double lean, double up, double coefficient) noexcept;
inline constexpr double kMaxSlopeFactor = 2.5;

/// A plane that may push: its normal and multiplier (m), and the felt normal in its place, if that is one.
struct Push {
    Vec3 normal = Vec3::UnitZ();
    double lambda = 0;
    std::optional<Vec3> felt;
};

/// Normal force on pushes[on] divided by the stiffness, in m, and what its felt slope makes of that for a
/// slide along the unit vector `way`: friction holds `coefficient` times this. Thread: real time.
double depthOnSlope(std::span<const Push> pushes, std::size_t on, double coefficient,
                    const Vec3& way) noexcept;

/// How far the proxy slides in a time.
/// `excess`: distance from the proxy to where it would go without friction, that is tangential force / k, at
/// the end of the time. `depth`: normal force / k, the sum of depthShare(). `speed`: of the finger in the
/// direction of the slide, m/s, so that the excess was excess - speed dt when the time began. Units: m, s.
///
/// Equation (21) in magnitudes along the slide, b e' = b speed - k (e - mu depth), is linear: solved exactly
/// over dt, it never overshoots, gives mu depth k + b speed when steady, and for b = 0 ends on the edge of
/// the cone. Returns 0 for a contact that holds. Thread: real time.
double allowedSlide(const FrictionLimit& limit, double excess, double depth, double speed,
                    double dt) noexcept;

/// What a slide against viscosity follows, by the end of a time, of a change that comes evenly in it: of a
/// slope or a friction that passes under the proxy. From 0 to 1, which is all, as without viscosity. The
/// same equation under a ramp. Thread: real time.
double followedPart(double lag, double dt) noexcept;

} // namespace tactum
