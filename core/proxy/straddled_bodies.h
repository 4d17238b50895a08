// Surfaces that are felt from one side alone, while the proxy is half through them: on which side it counts.
#pragma once

#include <algorithm>
#include <span>

#include "core/motion/movers.h"
#include "core/proxy/proxy.h"

namespace tactum {

/// The place whose side of a body's surfaces counts as that of a proxy at `at_B`: its own, or while it
/// overlaps the body, the last one where it did not. Body frame. Thread: real time.
inline Vec3 cameFrom(const ProxyState& state, std::uint32_t body, const Vec3& at_B) noexcept {
    const auto end = state.straddled.begin() + state.straddledCount;
    const auto found =
        std::find_if(state.straddled.begin(), end, [body](const StraddledBody& s) { return s.body == body; });
    return found == end ? at_B : found->from_B;
}

/// Whether anything has such surfaces: else there is nothing to follow. Thread: real time.
inline bool anyOneSided(std::span<const Obstacle> obstacles) noexcept {
    return std::any_of(obstacles.begin(), obstacles.end(),
                       [](const Obstacle& o) { return !o.sides.empty(); });
}

/// After the bodies went on by a piece of their way, from one part of it to another (0 before the step, 1
/// after): the proxy was at `before_W` then. What it overlaps now of all that is felt from one side alone,
/// and from where it came, is in the state. Forgotten is what it is clear of, and what was put into it from
/// farther away than it is wide, which it did not come to. World frame, metre. Thread: real time; one
/// nearestOn() of each such obstacle within the radius.
void followCarried(ProxyState& state, std::span<const Obstacle> obstacles, const StepMotions& movers,
                   double radius, const Vec3& before_W, double from, double to,
                   const NearBodies* near = nullptr) noexcept;

/// The same after a move of the proxy alone: the side counts that it was on when the move began, or before it
/// began to overlap.
void followMoved(ProxyState& state, std::span<const Obstacle> obstacles, const StepMotions& movers,
                 double radius, const Vec3& before_W, const NearBodies* near = nullptr) noexcept;

} // namespace tactum
