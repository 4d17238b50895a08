#include "core/runtime/servo_telemetry.h"

namespace tactum {
namespace {

/// A finger that was put elsewhere has to begin anew: that is no pause.
void countPause(const ServoState& state, ServoTelemetry& telemetry) noexcept {
    const bool taken = telemetry.gain > 0 && state.gate.gain() == 0;
    if (!taken || !isPause(state.gate.inhibit()) || state.check.believed().jumped) return;
    ++telemetry.pauses;
    telemetry.lastPause = state.gate.inhibit();
}

} // namespace

void note(ServoTelemetry& telemetry, const ServoOutput& output, const ServoState& state) noexcept {
    countPause(state, telemetry);
    if (output.finger.valid) telemetry.finger = output.finger.position;
    telemetry.force = output.frame.turned(output.force);
    telemetry.handle_D = state.check.believed().position;
    telemetry.buttons = state.check.believed().buttons;
    telemetry.frame = output.frame;
    telemetry.border = output.border;
    telemetry.ticks = state.ticks;
    telemetry.clamped = state.limiter.clamped;
    telemetry.invalidSamples = state.check.refused();
    telemetry.inhibit = state.gate.inhibit();
    telemetry.gain = state.gate.gain();
    telemetry.faults = state.gate.faults();
    telemetry.oscillations = state.schedule.oscillations();
    telemetry.stiffnessScale = state.schedule.scale();
    telemetry.heat = state.heat.heat();
    telemetry.energy = state.passivity.energy();
    telemetry.passivityDamping = state.passivity.lastDamping();
    const double rendered = state.previous.touching ? state.transition.rendered().stiffness : 0;
    telemetry.rendered = state.gate.gain() * rendered / output.frame.scale;
    telemetry.grasped = state.schedule.grasping();
    telemetry.doubted = state.schedule.doubted();
    telemetry.ceiling = state.schedule.ceiling();
    telemetry.ceiling.value /= output.frame.scale;
    telemetry.ceiling.damping /= output.frame.scale;
}

} // namespace tactum
