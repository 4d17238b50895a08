#include "core/runtime/servo_step.h"

#include <algorithm>

namespace tactum {
namespace {

/// After a limit cycle the stiffness falls to its half over the first time; it doubles again over the second,
/// while nothing is touched: a spring that stiffens under load gives energy. Unit: s.
constexpr double kFade = 0.05, kRecovery = 2;
constexpr double kLeastCalm = 1.0 / 32;

/// What a clock may say that stood still or went wrong. Unit: s.
double plausible(double dt) noexcept {
    constexpr double kShortest = 1e-5, kLongest = 10;
    return dt > kShortest ? std::min(dt, kLongest) : kShortest;
}

/// The device's frame D is the world's so far.
FingerSample fingerOf(const ServoState& state) noexcept {
    const DeviceSample& seen = state.check.believed();
    return {seen.position, seen.velocity, state.ticks, seen.valid, state.guard.anchoring()};
}

void calmDown(ServoState& state, const DeviceSample& seen, double dt) noexcept {
    if (!state.touching) state.calmGoal = std::min(1.0, state.calmGoal * std::exp2(dt / kRecovery));
    state.calm = std::min(1.0, state.calm + std::clamp(state.calmGoal - state.calm, -0.5 * dt / kFade, 1.0));
    if (seen.jumped) state.oscillation.forget();
    if (!state.oscillation(seen.position, dt) || state.guard.gain() == 0) return;
    ++state.oscillations;
    state.calmGoal = std::max(kLeastCalm, 0.5 * state.calmGoal);
}

/// The stiffness that is rendered at most, N/m: an oscillation takes from what is there, not from the
/// ceiling.
double ceilingOf(ServoState& state, const ServoSettings& settings, double stiffness) noexcept {
    LoopFigures loop = state.loop;
    loop.period = std::max(loop.period, settings.period);
    state.ceiling = safeStiffness(loop);
    return state.calm * (settings.overrideCeiling ? stiffness : std::min(stiffness, state.ceiling.value));
}

/// What the model asks for.
struct Wanted {
    RenderedSpring spring;
    Vec3 sliding = Vec3::Zero(); ///< m/s, of the finger relative to what it touches; zero in free motion
    double sudden = 0;           ///< N, that the finger's own way does not explain
};

Wanted render(ServoState& state, const LocalContactModel& model, const FingerSample& finger, bool fresh,
              double ceiling, double dt) noexcept {
    if (state.guard.gain() == 0) state.ease.restart();
    const LocalContactModel& eased = state.ease(model, fresh, finger.position, finger.velocity, ceiling, dt);
    const Anchor anchor = anchorOf(eased, finger.position);
    state.anchor = anchor.position;
    state.touching = anchor.touching;
    const double stretch = (anchor.position - finger.position).norm();
    const double unexplained = stretch - state.stretch - (finger.position - state.finger).norm();
    state.stretch = stretch;
    state.finger = finger.position;
    if (!anchor.touching) return {};
    return {{springForce(eased, anchor.position, finger.position, finger.velocity), eased.stiffness, stretch,
             state.limiter.maxForce, eased.velocity},
            finger.velocity - eased.velocity,
            eased.stiffness * unexplained};
}

/// What of it may be rendered.
RenderedSpring guarded(ServoState& state, const Wanted& wanted, const Vec3& velocity,
                       const GuardInput& tick) noexcept {
    const double gain = state.guard(tick);
    if (gain == 0) return {};
    RenderedSpring spring = wanted.spring;
    spring.stiffness *= gain;
    const double damping = state.passivity.damping(spring, wanted.sliding, tick.dt);
    // Beyond what the device can push no damping would be felt.
    spring.force = state.limiter(gain * spring.force) - damping * wanted.sliding;
    if (state.touching) spring.force -= state.guard.arrivalDamping() * velocity;
    return spring;
}

} // namespace

ServoState::ServoState(const DeviceInfo& device) noexcept
    : loop(loopFigures(device)), check(device), guard(device.maxForce, device.tripSpeed), passivity(device),
      heat(device.maxForce, device.continuousForce), limiter{device.maxForce} {}

ServoOutput servoStep(ServoState& state, const ServoSettings& settings, const ServoInput& input,
                      const LocalContactModel& model) noexcept {
    const double dt = plausible(input.dt);
    ++state.ticks;
    state.check(input.sample, dt);
    const DeviceSample& seen = state.check.believed();
    if (seen.jumped) state.guard.begin();
    state.passivity.observe(seen.position, seen.velocity, dt);
    calmDown(state, seen, dt);
    state.limiter.maxForce = state.heat.limit();

    FingerSample finger = fingerOf(state);
    const double ceiling = ceilingOf(state, settings, model.stiffness);
    const Wanted wanted = render(state, model, finger, input.fresh, ceiling, dt);
    state.modelAge = input.fresh ? 0 : state.modelAge + dt;

    const GuardInput tick{.dt = dt,
                          .late = input.late,
                          .armed = settings.armed,
                          .held = settings.deadMan == 0 || (seen.buttons & settings.deadMan) != 0,
                          .deviceLost = state.check.lost(),
                          .answered = model.valid && model.anchoring == finger.anchoring &&
                                      state.modelAge <= kModelPatience,
                          .speed = finger.velocity.norm(),
                          .wanted = wanted.spring.force.norm(),
                          .sudden = wanted.sudden,
                          .finite = wanted.spring.force.allFinite() && wanted.sliding.allFinite() &&
                                    std::isfinite(wanted.sudden)};
    RenderedSpring spring = guarded(state, wanted, finger.velocity, tick);
    spring.force = state.limiter(spring.force);
    state.heat.add(spring.force.norm(), dt);
    state.passivity.commanded(spring);
    finger.anchoring = state.guard.anchoring();
    return {spring.force, finger};
}

} // namespace tactum
