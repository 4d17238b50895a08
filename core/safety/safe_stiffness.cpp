#include "core/safety/safe_stiffness.h"

#include <algorithm>

namespace tactum {
namespace {
/// Of what a lossless partner bears. No hand is one, and what a hand does not take up the passivity
/// controller does: held hands stand two to four times as much (docs/stability.md).
constexpr double kOfTheLosses = 1.05;
/// What a count makes is too little for any controller to see.
constexpr double kOfTheCount = 0.7;
constexpr double kSurfaceShare = 1.0 / 3; ///< of the losses, that a surface's own damping may use up
} // namespace

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
    const double late = lateness(loop);
    const double losses = kOfTheLosses * loop.damping;
    if (!(late > 0) || !(losses > 0)) return {};
    StiffnessCeiling ceiling{losses / late, CeilingReason::Damping, kSurfaceShare * losses};
    const auto lower = [&ceiling](double value, CeilingReason reason) {
        if (value < ceiling.value) {
            ceiling.value = value;
            ceiling.reason = reason;
        }
    };
    if (loop.surfaceDamping > 0)
        lower((losses - std::min(ceiling.damping, loop.surfaceDamping)) / late,
              CeilingReason::SurfaceDamping);
    if (loop.dryFriction > 0 && loop.resolution > 0)
        lower(kOfTheCount * 2 * loop.dryFriction / loop.resolution, CeilingReason::Resolution);
    if (loop.handsCeiling > 0) lower(loop.handsCeiling, CeilingReason::Hand);
    if (loop.makersCeiling > 0) lower(loop.makersCeiling, CeilingReason::Maker);
    return ceiling;
}

} // namespace tactum
