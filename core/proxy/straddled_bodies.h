// Surfaces that are felt from one side alone, while the proxy is half through them: on which side it counts.
#pragma once

#include <algorithm>
#include <span>

#include "core/dynamics/body_motion.h"
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

/// After a step that began at `before_W`: what the proxy overlaps now, of all that is felt from one side
/// alone, and from where it came. What it is clear of is forgotten, and what jumped into it, which it did not
/// come to. World frame, metre. Thread: real time; one nearestOn() of each such obstacle within the radius.
void followStraddled(ProxyState& state, std::span<const Obstacle> obstacles,
                     std::span<const BodyMotion> movers, double radius, const Vec3& before_W) noexcept;

} // namespace tactum
