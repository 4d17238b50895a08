#include "core/runtime/servo_telemetry.h"

namespace tactum {
namespace {

/// A finger that was put elsewhere has to begin anew: that is no pause.
void countPause(const ServoState& state, ServoTelemetry& telemetry) noexcept {
    const bool taken = telemetry.gain > 0 && state.guard.gain() == 0;
    if (!taken || !isPause(state.guard.withheld()) || state.check.believed().jumped) return;
    ++telemetry.pauses;
    telemetry.lastPause = state.guard.withheld();
}

} // namespace

void note(ServoTelemetry& telemetry, const ServoOutput& output, const ServoState& state) noexcept {
    countPause(state, telemetry);
    if (output.finger.valid) telemetry.finger = output.finger.position;
    telemetry.force = output.frame.turned(output.force);
    telemetry.handle = state.check.believed().position;
    telemetry.buttons = state.check.believed().buttons;
    telemetry.frame = output.frame;
    telemetry.ticks = state.ticks;
    telemetry.clamped = state.limiter.clamped;
    telemetry.invalidSamples = state.check.refused();
    telemetry.withheld = state.guard.withheld();
    telemetry.gain = state.guard.gain();
    telemetry.faults = state.guard.faults();
    telemetry.oscillations = state.oscillations;
    telemetry.calm = state.calm;
    telemetry.heat = state.heat.heat();
    telemetry.energy = state.passivity.energy();
    telemetry.passivityDamping = state.passivity.lastDamping();
    telemetry.ceiling = state.ceiling;
    telemetry.ceiling.value /= output.frame.scale;
    telemetry.ceiling.damping /= output.frame.scale;
}

} // namespace tactum
