#include "core/proxy/proxy.h"

#include "core/proxy/carry.h"
#include "core/proxy/step.h"

namespace tactum {

void restart(ProxyState& state, const Vec3& finger_W) noexcept {
    state.position = state.finger = finger_W;
    state.contactCount = state.passedCount = state.straddledCount = state.feltCount = 0;
    state.speed = 0;
    state.slidingOn = kNoBody;
    for (SweepMemory& memory : state.memories)
        memory.mesh = nullptr;
}

ProxyReport moveAndUpdate(ProxyState& state, std::span<const Obstacle> obstacles, double radius,
                          const Vec3& finger_W, double dt, const StepMotions& movers, int mostRounds,
                          const NearBodies* near) noexcept {
    const CarryReport carried = carry(state, obstacles, movers, radius, near);
    ProxyReport report =
        Step(state, obstacles, movers, radius, finger_W, dt, carried.start, mostRounds, near).run();
    report.squeezed |= carried.squeezed;
    report.passed = carried.passed;
    return report;
}

} // namespace tactum
