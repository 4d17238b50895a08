#include "core/runtime/servo_loop.h"

#include <algorithm>
#include <cmath>

#include "core/base/clock.h"
#include "core/base/realtime.h"
#include "core/port/reading_clock.h"
#include "core/runtime/latency_monitor.h"
#include "core/safety/model_in_device.h"

namespace tactum {
namespace {

/// What the servo remembers from tick to tick.
struct Servo {
    Servo(HandChannels& theChannels, const DeviceInfo& device) noexcept
        : channels(theChannels), state(device), workspace(device) {}

    HandChannels& channels;
    ServoState state;
    WorkspaceTracker workspace;
    ReadingClock readings;
    AroundHand around; ///< of the last tick
    HalfSecond jitter;
    RecentPeriods periods;
    WatchdogCheck watchdogCheck;
    bool unguarded = false;
    double period = 0; ///< s, measured
    LatencyMonitor latency;
    ServoTelemetry telemetry;
    double begun = 0; ///< s, when the metronome was made, on the recorder's clock
};

/// Everything that this tick depends on.
ServoRow rowOf(const Servo& servo, const DeviceSample& sample, double apart, const DeviceFrame& frame,
               const Tick& tick, bool fresh) noexcept {
    const HandChannels& channels = servo.channels;
    const auto flag = [](bool on, ServoRow::Flag bit) { return on ? std::uint32_t(bit) : 0; };
    return {.time = servo.begun + tick.time,
            .dt = tick.elapsed,
            .apart = apart,
            .position = tripleOf(sample.position),
            .velocity = tripleOf(sample.velocity),
            .offset = tripleOf(frame.offset),
            .scale = frame.scale,
            .axes = {frame.axes[0], frame.axes[1], frame.axes[2]},
            .outside = tripleOf(frame.turnedBack(wantedOf(channels.outside.value(), monotonicNanoseconds()))),
            .border = servo.workspace.border(),
            .model = channels.contactModel.value().steps,
            .period = servo.period,
            .buttons = sample.buttons,
            .deadMan = channels.deadMan.load(std::memory_order_relaxed),
            .flags = flag(sample.valid, ServoRow::Valid) |
                     flag(sample.jumped || servo.workspace.jumped(), ServoRow::Jumped) |
                     flag(tick.missed, ServoRow::Late) | flag(fresh, ServoRow::Fresh) |
                     flag(servo.unguarded, ServoRow::Unguarded) |
                     flag(servo.workspace.clutched(), ServoRow::Clutched) |
                     flag(sample.stopped, ServoRow::Stopped) |
                     flag(channels.armed.load(std::memory_order_relaxed), ServoRow::Armed) |
                     flag(channels.fading.load(std::memory_order_relaxed), ServoRow::Fading) |
                     flag(channels.overrideCeiling.load(std::memory_order_relaxed), ServoRow::Override) |
                     flag(channels.grasped.load(std::memory_order_relaxed), ServoRow::Grasped)};
}

ServoOutput stepServo(Servo& servo, const DeviceSample& sample, const Tick& tick) noexcept {
    const bool fresh = servo.channels.contactModel.update();
    servo.channels.outside.update();
    if (servo.channels.workspace.update()) servo.workspace.decide(servo.channels.workspace.value());
    const double apart = servo.readings(sample, tick.elapsed, monotonicNanoseconds());
    DeviceSample credible = sample;
    credible.valid = servo.state.check.believes(sample, apart);
    lookAround(servo.around, servo.channels.contactModel.value().model);
    const DeviceFrame& frame = servo.workspace.follow(credible, servo.around, tick.elapsed);
    ServoRow row = rowOf(servo, sample, apart, frame, tick, fresh);
    Recorder& recorder = servo.channels.recorder;
    recorder.begin(row, servo.state);
    const ServoOutput output = stepFrom(row, servo.state, servo.channels.contactModel.value().model);
    note(row, output, servo.state);
    recorder.end(row);
    servo.around.pushing = !output.force.isZero(0);
    servo.around.forces = servo.state.gate.gain() > 0;
    return output;
}

/// What all but one tick in a thousand kept lately: without real-time priority that is worse than the nominal
/// period, and less stiffness is safe.
void measurePeriod(Servo& servo, double nominal) noexcept {
    constexpr std::uint64_t kEvery = 1024;
    if (servo.state.ticks % kEvery == 0)
        servo.period = nominal + 1e-6 * servo.telemetry.periods.quantile(0.999);
}

void reportTick(Servo& servo, const ServoOutput& output, const Tick& tick, double period) noexcept {
    servo.jitter.add(tick.time, 1e6 * std::abs(tick.elapsed - period));
    ServoTelemetry& telemetry = servo.telemetry;
    note(telemetry, output, servo.state);
    telemetry.rate = servo.jitter.rate();
    telemetry.jitterMicros = servo.jitter.worst();
    servo.periods.add(tick.time, 1e6 * (tick.elapsed - period));
    telemetry.periods = servo.periods.counted();
    servo.channels.servoTelemetry.write(telemetry);
    // A full queue means that nobody draws plots: the tick is dropped.
    const NumberedModel& now = servo.channels.contactModel.value();
    servo.channels.trace.push(tracePoint(tick.time, telemetry, output, now.model, now.touched));
}

void countMisses(Servo& servo, const Tick& tick, double period) noexcept {
    const bool own = servo.latency.isOwn(period);
    servo.telemetry.misses += tick.missed;
    servo.telemetry.machineMisses += tick.missed && !own;
}

} // namespace

void servoLoop(HandChannels& channels, HapticDevice& device, const DeviceInfo& info, LeftHeat& motors,
               DeviceWatchdog& watchdog, Clock sinceBoot) noexcept {
    Servo servo(channels, info);
    servo.state.heat.resume(motors.heat, 1e-9 * double(monotonicNanoseconds() - motors.at));
    servo.begun = channels.recorder.now();
    Metronome metronome(info.rate, 0, sinceBoot);
    DeviceCommand command;
    while (!channels.stop.load(std::memory_order_relaxed)) {
        const Tick tick = metronome.wait(device);
        // Nobody has felt the force of before a stall since; now it would be a kick.
        if (tick.elapsed > kStall) command = DeviceCommand{};
        const DeviceSample sample = device.exchange(command, tick.elapsed);

        const RealtimeScope scope;
        watchdog.beat();
        servo.unguarded = servo.watchdogCheck.isDead(watchdog, tick.elapsed);
        const ServoOutput output = stepServo(servo, sample, tick);
        channels.finger.write(output.finger);
        command.force = output.force;
        device.announce(command);
        countMisses(servo, tick, metronome.period());
        reportTick(servo, output, tick, metronome.period());
        measurePeriod(servo, metronome.period());
    }
    watchdog.rest();
    device.exchange(DeviceCommand{}, metronome.period());
    motors = {servo.state.heat.heat(), monotonicNanoseconds()};
}

} // namespace tactum
