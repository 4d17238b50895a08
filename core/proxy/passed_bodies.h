// Bodies that passed over the proxy where no room was left: when they are felt again.
#pragma once

#include <algorithm>
#include <span>

#include "core/motion/movers.h"
#include "core/proxy/proxy.h"

namespace tactum {

/// Whether a body is not felt because it passed over the proxy. Thread: real time.
inline bool hasPassed(const ProxyState& state, std::uint32_t body) noexcept {
    const auto end = state.passed.begin() + state.passedCount;
    return std::any_of(state.passed.begin(), end, [body](const PassedBody& p) { return p.body == body; });
}

/// What passed over the proxy is felt again as soon as a straight way for a sphere of `radius` leads from
/// where the proxy was on it to where the proxy is. Until then that place slides along the body after the
/// proxy. Thread: real time; two sweeps of each body that passed.
void followPassed(ProxyState& state, std::span<const Obstacle> obstacles, const StepMotions& movers,
                  double radius) noexcept;

} // namespace tactum
