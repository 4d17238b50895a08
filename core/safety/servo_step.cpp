#include "core/safety/servo_step.h"

#include <algorithm>
#include <limits>

#include "core/safety/model_in_device.h"

namespace tactum {
namespace {

/// After a limit cycle the stiffness falls to its half over the first time, and so it does for as long as the
/// surface has made too much and is damped: who bounces more slowly than any limit cycle would else be thrown
/// farther each time. It doubles again over the second, while nothing is touched: a spring that stiffens
/// under load gives energy. Unit: s.
constexpr double kFade = 0.05, kRecovery = 2;
constexpr double kLeastCalm = 1.0 / 32;

/// What a clock may say that stood still or went wrong. Unit: s.
double plausible(double dt) noexcept {
    constexpr double kShortest = 1e-5, kLongest = 10;
    return dt > kShortest ? std::min(dt, kLongest) : kShortest;
}

/// For the proxy loop; under the clutch the finger rests.
FingerSample inWorld(const ServoState& state, const ServoInput& input) noexcept {
    const DeviceSample& seen = state.check.believed();
    const Vec3 velocity = input.clutched ? Vec3::Zero() : input.frame.wayInWorld(seen.velocity);
    return {input.frame.pointInWorld(seen.position), velocity, state.ticks, seen.valid,
            state.guard.anchoring()};
}

/// Whether the person holds what must be held. A button that was never seen let go since the device came is
/// stuck, and tells nothing.
bool isHeld(ServoState& state, const DeviceSample& seen, std::uint32_t deadMan) noexcept {
    state.letGo = seen.valid ? state.letGo | ~seen.buttons : 0;
    return deadMan == 0 || (seen.buttons & deadMan & state.letGo) != 0;
}

void calmDown(ServoState& state, const DeviceSample& seen, double dt) noexcept {
    if (!state.touching)
        state.calmGoal = std::min(1.0, state.calmGoal * std::exp2(dt / kRecovery));
    else if (state.guard.gain() > 0 && state.passivity.lastDamping() > 0 &&
             state.passivity.energy() > kPassivityThreshold)
        state.calmGoal = std::max(kLeastCalm, state.calmGoal * std::exp2(-dt / kFade));
    state.calm = std::min(1.0, state.calm + std::clamp(state.calmGoal - state.calm, -0.5 * dt / kFade, 1.0));
    if (seen.jumped) state.oscillation.forget();
    if (!state.oscillation(seen.position, dt) || state.guard.gain() == 0) return;
    ++state.oscillations;
    state.calmGoal = std::max(kLeastCalm, 0.5 * state.calmGoal);
}

/// What is rendered at most, N/m and N s/m.
struct TickBounds {
    double stiffness, damping;
    double leaving; ///< N/m, of what is not there any more, and damps no more
};

/// What raises the ceiling would throw the hand under load: a machine that is in time again is believed no
/// faster than an edit, a person who knows better from the next contact on.
void notice(ServoState& state, const ServoSettings& settings, double dt) noexcept {
    const double stiffness = state.ease.rendered().stiffness;
    const bool loaded = state.touching && state.guard.gain() > 0;
    const double load = loaded ? stiffness * (state.anchor - state.finger).norm() : 0;
    const double change = load > 0 ? editRate(stiffness) * dt / load : 1; // part of stiffness and period
    state.period = std::max({state.loop.period, settings.period, state.period * std::max(0.0, 1 - change)});
    state.overriding = settings.overrideCeiling && (state.overriding || !loaded);
}

/// An oscillation takes from what is there, not from the ceiling.
TickBounds boundsOf(ServoState& state, const LocalContactModel& model) noexcept {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    LoopFigures loop = state.loop;
    loop.period = state.period;
    const double undamped = safeStiffness(loop).value;
    loop.surfaceDamping = model.damping;
    state.ceiling = safeStiffness(loop);
    if (state.overriding) return {state.calm * model.stiffness, state.calm * model.damping, kNone};
    return {state.calm * std::min(model.stiffness, state.ceiling.value),
            state.calm * std::min(model.damping, state.ceiling.damping), state.calm * undamped};
}

/// What the model asks for.
struct Wanted {
    RenderedSpring spring;
    Vec3 sliding = Vec3::Zero(); ///< m/s, of the finger relative to what it touches; zero in free motion
    double sudden = 0;           ///< N, that the finger does not explain
};

/// N, that neither the finger's way nor a hit explains: what this tick's surroundings push more than those of
/// the last tick would, met by the same finger. A step of the force is judged whole, in N and not in N/s: an
/// anchor or a damping that jumps does so within one tick, however long that is.
double suddenOf(const ServoState& state, const LocalContactModel& before, const DeviceSample& finger,
                const LocalContactModel& now, const Vec3& force, double since) noexcept {
    ForceLimiter limited{state.limiter.maxForce};
    const Anchor last = anchorOf(before, finger.position, since);
    const Vec3 expected =
        last.touching ? springForce(before, last.position, finger.position, finger.velocity) : Vec3::Zero();
    const double way = (finger.position - state.finger).norm();
    const double hit = last.touching ? 0 : now.damping * (finger.velocity - now.velocity).norm();
    return rise(limited(force), limited(expected)) - now.stiffness * way - hit;
}

Wanted render(ServoState& state, const LocalContactModel& model, const DeviceSample& finger, bool fresh,
              const TickBounds& bounds, double dt) noexcept {
    if (state.guard.gain() == 0) state.ease.restart();
    const LocalContactModel before = state.ease.rendered();
    LocalContactModel bounded = model;
    bounded.damping = bounds.damping;
    const LocalContactModel& eased =
        state.ease(bounded, fresh, finger.position, finger.velocity,
                   {bounds.stiffness, bounds.leaving, state.limiter.maxForce}, dt);
    const double since = state.ease.since(dt);
    const Anchor anchor = anchorOf(eased, finger.position, since);
    state.anchor = anchor.position;
    state.touching = anchor.touching;
    Wanted wanted;
    if (anchor.touching) {
        const Vec3 force = springForce(eased, anchor.position, finger.position, finger.velocity);
        wanted = {{force, eased.stiffness, (anchor.position - finger.position).norm(), state.limiter.maxForce,
                   eased.velocity},
                  finger.velocity - eased.velocity,
                  suddenOf(state, before, finger, eased, force, since)};
    }
    state.finger = finger.position;
    return wanted;
}

/// What of it may be rendered.
RenderedSpring guarded(ServoState& state, const Wanted& wanted, const Vec3& velocity,
                       const GuardInput& tick) noexcept {
    const double gain = state.guard(tick);
    if (gain == 0) {
        state.passivity.rest();
        return {};
    }
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
                      const LocalContactModel& model_W) noexcept {
    const double dt = plausible(input.dt);
    const LocalContactModel model = inDevice(model_W, input.frame);
    ++state.ticks;
    const double apart = input.apart > 0 ? plausible(input.apart) : 0;
    const bool news = state.check(input.sample, apart) && apart > 0;
    state.unread = news ? 0 : state.unread + dt;
    const DeviceSample& seen = state.check.believed();
    if (seen.jumped) state.guard.begin();
    calmDown(state, seen, dt); // by the balance of the last tick: with a way, but no spring yet, it is none
    state.passivity.observe(seen.position, seen.velocity, dt);
    if (dt > kStall) state.passivity.notSent();
    state.limiter.maxForce = state.heat.limit();

    notice(state, settings, dt);
    const TickBounds bounds = boundsOf(state, model);
    const Wanted wanted = render(state, model, seen, input.fresh, bounds, dt);
    state.modelAge = input.fresh ? 0 : state.modelAge + dt;

    const GuardInput tick{.dt = dt,
                          .unread = state.unread,
                          .late = input.late,
                          .armed = settings.armed,
                          .held = isHeld(state, seen, settings.deadMan),
                          .clutched = input.clutched,
                          .stopped = input.sample.stopped,
                          .deviceLost = state.check.lost(),
                          .unguarded = input.unguarded,
                          .answered = model.valid && model.anchoring == state.guard.anchoring() &&
                                      state.modelAge <= kModelPatience,
                          .speed = seen.velocity.norm(),
                          .wanted = wanted.spring.force.norm(),
                          .sudden = wanted.sudden,
                          .finite = wanted.spring.force.allFinite() && wanted.sliding.allFinite() &&
                                    std::isfinite(wanted.sudden)};
    RenderedSpring spring = guarded(state, wanted, seen.velocity, tick);
    spring.force = state.limiter(spring.force);
    state.heat.add(spring.force.norm(), dt);
    state.passivity.commanded(spring);
    return {spring.force, inWorld(state, input), input.frame};
}

} // namespace tactum
