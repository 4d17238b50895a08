// Where the proxy can be when it was not led there: at the start, and after the scene was changed around it.
#pragma once

#include <optional>
#include <span>

#include "core/proxy/contact.h"

namespace tactum {

/// A clear place for a proxy of `radius`, as near to `wanted_W` as pushing it off what it would overlap
/// brings it: `wanted_W` itself where that is clear. Nothing where none is found, as in a slot that is too
/// narrow. A closed obstacle that came to its place after the shape `since` is left through its nearest
/// surface when the proxy is found inside; of one that was there before, the inside is a place like others.
/// World frame, metre. Thread: real time; some dozens of nearestOn().
std::optional<Vec3> clearPlace(std::span<const Obstacle> obstacles, std::span<const BodyMotion> movers,
                               double radius, const Vec3& wanted_W, std::uint64_t since) noexcept;

} // namespace tactum
