#include "core/proxy/proxy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/inplace_vector.h"
#include "core/proxy/carry.h"
#include "core/proxy/felt_planes.h"
#include "core/proxy/passed_bodies.h"
#include "core/proxy/straddled_bodies.h"
#include "core/surface/friction.h"

namespace tactum {

void restart(ProxyState& state, const Vec3& finger_W) noexcept {
    state.position = state.finger = finger_W;
    state.contactCount = state.passedCount = state.straddledCount = state.feltCount = 0;
    state.speed = 0;
    state.slidingOn = kNoBody;
    for (SweepMemory& memory : state.memories)
        memory.mesh = nullptr;
}

namespace {
#include "core/proxy/step/step.inc"

#include "core/proxy/step/curved.inc"
#include "core/proxy/step/felt.inc"
#include "core/proxy/step/friction.inc"
#include "core/proxy/step/rounds.inc"
#include "core/proxy/step/sweep.inc"
} // namespace

ProxyReport moveAndUpdate(ProxyState& state, std::span<const Obstacle> obstacles, double radius,
                          const Vec3& finger_W, double dt, std::span<const BodyMotion> movers,
                          int mostRounds) noexcept {
    const CarryReport carried = carry(state, obstacles, movers, radius);
    ProxyReport report =
        Step(state, obstacles, movers, radius, finger_W, dt, carried.start, mostRounds).run();
    report.squeezed |= carried.squeezed;
    report.passed = carried.passed;
    return report;
}

} // namespace tactum
