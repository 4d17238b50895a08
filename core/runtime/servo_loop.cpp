#include "core/runtime/servo_loop.h"

#include <algorithm>
#include <cmath>

#include "core/base/realtime.h"
#include "core/runtime/metronome.h"

namespace tactum {
namespace {

/// What the servo remembers from tick to tick.
struct Servo {
    Servo(Channels& theChannels, const DeviceInfo& device) noexcept : channels(theChannels), state(device) {}

    Channels& channels;
    ServoState state;
    HalfSecond jitter;
    ServoTelemetry telemetry;
};

ServoSettings settingsOf(const Channels& channels) noexcept {
    return {.armed = channels.armed.load(std::memory_order_relaxed),
            .overrideCeiling = channels.overrideCeiling.load(std::memory_order_relaxed)};
}

void report(Servo& servo, const ServoOutput& output, const Tick& tick, double period) noexcept {
    const ServoState& state = servo.state;
    servo.jitter.add(tick.time, 1e6 * std::abs(tick.elapsed - period));
    ServoTelemetry& telemetry = servo.telemetry;
    if (output.finger.valid) telemetry.finger = output.finger.position;
    telemetry.force = output.force;
    telemetry.ticks = state.ticks;
    telemetry.rate = servo.jitter.rate();
    telemetry.jitterMicros = servo.jitter.worst();
    telemetry.misses += tick.missed;
    telemetry.clamped = state.limiter.clamped;
    telemetry.invalidSamples = state.check.refused();
    telemetry.withheld = state.guard.withheld();
    telemetry.gain = state.guard.gain();
    telemetry.faults = state.guard.faults();
    telemetry.oscillations = state.oscillations;
    telemetry.calm = state.calm;
    telemetry.heat = state.heat.heat();
    telemetry.energy = state.passivity.energy();
    telemetry.passivityDamping = state.passivity.damping();
    telemetry.ceiling = state.ceiling;
    servo.channels.servoTelemetry.write(telemetry);
    // A full queue means that nobody draws plots: the tick is dropped.
    servo.channels.trace.push(
        {tick.time, telemetry.finger, servo.channels.contactModel.value().proxy, output.force});
}

} // namespace

void servoLoop(Channels& channels, HapticDevice& device, const DeviceInfo& info,
               Guardian& guardian) noexcept {
    Servo servo(channels, info);
    Metronome metronome(info.rate);
    DeviceCommand command;
    while (!channels.stop.load(std::memory_order_relaxed)) {
        const Tick tick = metronome.wait();
        const DeviceSample sample = device.exchange(command, tick.elapsed);

        const RealtimeScope scope;
        guardian.beat();
        const bool fresh = channels.contactModel.update();
        const ServoOutput output =
            servoStep(servo.state, settingsOf(channels),
                      {.sample = sample, .dt = tick.elapsed, .late = tick.missed, .fresh = fresh},
                      channels.contactModel.value());
        channels.finger.write(output.finger);
        command.force = output.force;
        report(servo, output, tick, metronome.period());
    }
    guardian.rest();
    device.exchange(DeviceCommand{}, metronome.period());
}

} // namespace tactum
