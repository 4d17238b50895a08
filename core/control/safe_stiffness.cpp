#include "core/control/safe_stiffness.h"

namespace tactum {
namespace {
constexpr double kReserve = 0.7;
}

LoopFigures loopFigures(const DeviceInfo& device) noexcept {
    return {.period = 1 / device.rate,
            .delay = device.delay / device.rate,
            .amplifierLag = device.amplifierLag,
            .damping = device.damping + device.handDamping,
            .dryFriction = device.dryFriction,
            .resolution = device.positionResolution,
            .makersCeiling = device.maxStiffness};
}

StiffnessCeiling safeStiffness(const LoopFigures& loop) noexcept {
    const double late = 0.5 * loop.period + loop.delay + loop.amplifierLag;
    StiffnessCeiling ceiling{kReserve * loop.damping / late, CeilingReason::Damping};
    const auto lower = [&ceiling](double value, CeilingReason reason) {
        if (value < ceiling.value) ceiling = {value, reason};
    };
    if (loop.dryFriction > 0 && loop.resolution > 0)
        lower(kReserve * 2 * loop.dryFriction / loop.resolution, CeilingReason::Resolution);
    if (loop.makersCeiling > 0) lower(loop.makersCeiling, CeilingReason::Maker);
    return ceiling;
}

} // namespace tactum
