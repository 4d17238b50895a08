#include "core/runtime/servo_loop.h"

#include <algorithm>
#include <cmath>

#include "core/base/realtime.h"
#include "core/control/force_limiter.h"
#include "core/runtime/metronome.h"

namespace tactum {
namespace {

/// What the servo remembers from tick to tick.
struct Servo {
    Channels& channels;
    ForceLimiter limiter;
    double gain = 0;      ///< 0 while the force is withheld, then up to 1
    double modelTime = 0; ///< when the newest model was seen, s
    HalfSecond jitter;
    ServoTelemetry telemetry;
};

/// The reading as the proxy loop gets it. The device's frame D is the world's so far.
FingerSample fingerOf(const DeviceSample& sample, std::uint64_t tick) noexcept {
    const bool valid = sample.valid && sample.position.allFinite() && sample.velocity.allFinite();
    if (!valid) return {.tick = tick};
    return {sample.position, sample.velocity, tick, true};
}

const LocalContactModel& newestModel(Servo& servo, double now) noexcept {
    if (servo.channels.contactModel.update()) servo.modelTime = now;
    return servo.channels.contactModel.value();
}

Vec3 forceOn(const FingerSample& finger, const Tick& tick, Servo& servo) noexcept {
    const LocalContactModel& model = newestModel(servo, tick.time);
    const bool fresh = model.valid && tick.time - servo.modelTime <= kModelPatience;
    if (!servo.channels.armed.load(std::memory_order_relaxed) || !finger.valid || !fresh) {
        servo.gain = 0;
        return Vec3::Zero();
    }
    servo.gain = std::min(1.0, servo.gain + tick.elapsed / kForceReturn);
    return servo.gain * contactModelForce(model, finger.position, finger.velocity);
}

void report(Servo& servo, const FingerSample& finger, const Vec3& force, const Tick& tick,
            double period) noexcept {
    servo.jitter.add(tick.time, 1e6 * std::abs(tick.elapsed - period));
    ServoTelemetry& telemetry = servo.telemetry;
    if (finger.valid) telemetry.finger = finger.position;
    telemetry.force = force;
    telemetry.ticks = finger.tick;
    telemetry.rate = servo.jitter.rate();
    telemetry.jitterMicros = servo.jitter.worst();
    telemetry.misses += tick.missed;
    telemetry.clamped = servo.limiter.clamped;
    telemetry.invalidSamples += !finger.valid;
    servo.channels.servoTelemetry.write(telemetry);
    // A full queue means that nobody draws plots: the tick is dropped.
    servo.channels.trace.push(
        {tick.time, telemetry.finger, servo.channels.contactModel.value().proxy, force});
}

} // namespace

void servoLoop(Channels& channels, HapticDevice& device, const DeviceInfo& info) noexcept {
    Servo servo{.channels = channels, .limiter = {info.maxForce}, .jitter = {}, .telemetry = {}};
    Metronome metronome(info.rate);
    DeviceCommand command;
    for (std::uint64_t count = 1; !channels.stop.load(std::memory_order_relaxed); ++count) {
        const Tick tick = metronome.wait();
        const DeviceSample sample = device.exchange(command, tick.elapsed);

        const RealtimeScope scope;
        const FingerSample finger = fingerOf(sample, count);
        channels.finger.write(finger);
        command.force = servo.limiter(forceOn(finger, tick, servo));
        report(servo, finger, command.force, tick, metronome.period());
    }
    device.exchange(DeviceCommand{}, metronome.period());
}

} // namespace tactum
