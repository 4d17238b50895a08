// Where the proxy can be when it was not led there: at the start, and after the scene was changed around it.
#pragma once

#include <optional>
#include <span>

#include "core/proxy/contact.h"

namespace tactum {

class NearBodies;

/// Where the proxy was before, as far as that is known.
struct FormerPlace {
    std::uint64_t since; ///< shape revision: an obstacle that came to its place later was not there
    /// World frame, m: the finger left from there on an unknown way. Nothing: it is where it wants to be.
    std::optional<Vec3> at_W = {};
};

/// A clear place for a proxy of `radius`, as near to `wanted_W` as pushing it off what it would overlap
/// brings it: `wanted_W` itself where that is clear. Nothing where none is found, as in a slot that is too
/// narrow. A closed obstacle is left through its nearest surface when the proxy is found inside and was not
/// there before: because the obstacle was not there, or because the proxy was outside. Else the inside is a
/// place like others. `near`: of these obstacles, where they are many; without it each is looked at. World
/// frame, metre. Thread: real time; some dozens of nearestOn() of each body that is near.
std::optional<Vec3> clearPlace(std::span<const Obstacle> obstacles, const StepMotions& movers, double radius,
                               const Vec3& wanted_W, const FormerPlace& former,
                               const NearBodies* near = nullptr) noexcept;

} // namespace tactum
