#include "core/safety/servo_step.h"

#include <algorithm>
#include <cmath>

#include "core/safety/command_check.h"
#include "core/safety/model_in_device.h"

namespace tactum {
namespace {

/// What a clock may say that stood still or went wrong. Unit: s.
double plausible(double dt) noexcept {
    constexpr double kShortest = 1e-5, kLongest = 10;
    return dt > kShortest ? std::min(dt, kLongest) : kShortest;
}

/// In so long the finger may have gone around what it touched. Unit: s.
constexpr double kLongSilence = 0.5;

/// Stage 1 and 2. Returns the newest reading that was believed, with its velocity.
const DeviceSample& validate(ServoState& state, const ServoInput& input, double dt) noexcept {
    const double apart = input.apart > 0 ? plausible(input.apart) : 0;
    const bool news = state.check(input.sample, apart) && apart > 0;
    state.unread = news ? 0 : state.unread + dt;
    if (state.check.believed().jumped || (news && apart > kLongSilence)) state.gate.begin();
    return state.check.believed();
}

/// Stage 3.
StiffnessBounds ceilingOf(ServoState& state, const Previous& previous, const ServoSettings& settings,
                          const ServoInput& input, const LocalContactModel& model_D, double dt) noexcept {
    return state.schedule({.seen = state.check.believed(),
                           .dt = dt,
                           .late = input.late,
                           .period = settings.period,
                           .overrideCeiling = settings.overrideCeiling,
                           .grasped = settings.grasped,
                           .stiffness = model_D.stiffness,
                           .damping = model_D.damping,
                           .rendered = state.transition.rendered().stiffness,
                           .load = previous.touching ? std::max(previous.load, 1e-9) : 0,
                           .pushing = state.gate.gain() > 0,
                           .made = state.passivity.lastDamping() > 0 ? state.passivity.energy() : 0});
}

/// What stages 4 and 5 make of the model. Frame D, SI.
struct Contact {
    LocalContactModel model; ///< as it is rendered
    Anchor anchor;
    Vec3 force = Vec3::Zero();   ///< N, of spring and surface damping
    Vec3 sliding = Vec3::Zero(); ///< m/s, of the finger relative to what it touches; zero in free motion
    Vec3 arriving =
        Vec3::Zero(); ///< the same, but for the way back of a surface that was moved under the finger
    Vec3 expected = Vec3::Zero(); ///< N, what the surroundings of the last tick would push this finger with
    bool newly = false;           ///< those would not touch it

    double stretch(const Vec3& finger) const noexcept {
        return anchor.touching ? (anchor.position - finger).norm() : 0;
    }
    bool finite() const noexcept { return force.allFinite() && sliding.allFinite(); }
};

/// Stages 4 and 5.
Contact contactOf(ServoState& state, const LocalContactModel& model_D, const DeviceSample& seen, bool fresh,
                  const StiffnessBounds& bounds, double dt) noexcept {
    if (state.gate.gain() == 0) state.transition.restart();
    const LocalContactModel before = state.transition.rendered();
    LocalContactModel bounded = model_D;
    bounded.damping = bounds.damping;
    Contact contact;
    contact.model = state.transition(bounded, fresh, seen.position, seen.velocity,
                                     {bounds.stiffness, bounds.leaving, state.limiter.maxForce}, dt);
    const double since = state.transition.since(dt);
    contact.anchor = anchorOf(contact.model, seen.position, since);
    if (const Anchor last = anchorOf(before, seen.position, since); last.touching)
        contact.expected = springForce(before, last.position, seen.position, seen.velocity);
    else
        contact.newly = true;
    if (!contact.anchor.touching) return contact;
    contact.force = springForce(contact.model, contact.anchor.position, seen.position, seen.velocity);
    contact.sliding = seen.velocity - contact.model.velocity;
    contact.arriving = seen.velocity - state.transition.motion();
    return contact;
}

/// Whether the person holds what must be held. A button that was never seen let go since the device came is
/// stuck, and tells nothing.
bool isHeld(ServoState& state, const DeviceSample& seen, std::uint32_t deadMan) noexcept {
    state.letGo = seen.valid ? state.letGo | ~seen.buttons : 0;
    return deadMan == 0 || (seen.buttons & deadMan & state.letGo) != 0;
}

/// Stage 6.
GateInput gateInput(ServoState& state, const ServoSettings& settings, const ServoInput& input,
                    const LocalContactModel& model_D, const Contact& contact, double dt) noexcept {
    const DeviceSample& seen = state.check.believed();
    state.modelAge = input.fresh ? 0 : state.modelAge + dt;
    return {.dt = dt,
            .unread = state.unread,
            .armed = settings.armed,
            .fading = settings.fading,
            .held = isHeld(state, seen, settings.deadMan),
            .clutched = input.clutched,
            .stopped = input.sample.stopped,
            .deviceLost = state.check.lost(),
            .unguarded = input.unguarded,
            .answered = model_D.valid && model_D.anchoring == state.gate.anchoring() &&
                        state.modelAge <= kModelPatience,
            .speed = seen.velocity.norm(),
            .wanted = contact.force.norm(),
            .finite = contact.finite()};
}

/// Stage 7. The spring that is rendered, with all that is added to it.
RenderedSpring damped(ServoState& state, const Contact& contact, const Vec3& finger, double gain,
                      double dt) noexcept {
    if (gain == 0) {
        state.passivity.rest();
        state.damper.rest();
        return {};
    }
    RenderedSpring spring{gain * contact.force, gain * contact.model.stiffness, contact.stretch(finger),
                          state.limiter.maxForce, state.transition.ownMotion()};
    const double asked = state.passivity.damping(spring, contact.sliding, dt);
    spring.force = state.limiter(spring.force); // beyond what the device can push no damping would be felt
    const Vec3 brake = -asked * contact.sliding - state.gate.arrivalDamping() * contact.arriving;
    spring.force += state.damper(spring.force, brake, contact.sliding, state.limiter.maxForce, dt);
    return spring;
}

/// Stage 8. N, of the command that neither the last tick nor the finger's way nor a hit explains.
double suddenOf(const ServoState& state, const Previous& previous, const Contact& contact, const Vec3& finger,
                const Vec3& command) noexcept {
    ForceLimiter limit{state.limiter.maxForce};
    const Vec3 expected =
        limit(previous.gain * contact.expected) + previous.added_D + previous.gain * previous.outside_D;
    return suddenChange(limit(command), limit(expected),
                        {.stiffness = contact.model.stiffness,
                         .way = (finger - previous.finger_D).norm(),
                         .damping = contact.newly ? contact.model.damping : 0,
                         .speed = contact.sliding.norm()});
}

/// Of stage 9: N, of the border, as much of it as `force`, which comes first, leaves of the device's limit.
Vec3 borderOf(ServoState& state, const ServoInput& input, const Vec3& finger, const Vec3& force,
              double dt) noexcept {
    const double limit = state.limiter.maxForce;
    Vec3 border = state.gate.gain() * state.border(finger, input.border, limit, dt);
    if (const double b2 = border.squaredNorm(); b2 > 0 && (force + border).norm() > limit) {
        const double half = force.dot(border), room = std::max(0.0, limit * limit - force.squaredNorm());
        border *= std::clamp((std::sqrt(half * half + b2 * room) - half) / b2, 0.0, 1.0);
    }
    if (!border.allFinite()) border.setZero();
    state.border.commanded(border);
    return border;
}

/// What the hand gets of what the finger pushes with, in the world's measure. With the forces off nobody
/// feels it: then the finger is a pointer that pushes as the surface would.
Coupling couplingOf(const ServoState& state, const ServoSettings& settings, const ServoInput& input,
                    const StiffnessBounds& bounds, double dt) noexcept {
    Coupling coupling;
    coupling.force = state.limiter.maxForce;
    if (!settings.armed && state.gate.gain() == 0) return coupling;
    coupling.stiffness = state.gate.gain() * bounds.stiffness / input.frame.scale;
    // The answer is rendered from the next tick on, and until the one after it comes.
    coupling.delay = state.schedule.lateness() + dt + state.transition.since(dt);
    return coupling;
}

/// For the proxy loop; under the clutch the finger rests.
FingerSample inWorld(const ServoState& state, const ServoInput& input, const Coupling& coupling) noexcept {
    const DeviceSample& seen = state.check.believed();
    const Vec3 velocity = input.clutched ? Vec3::Zero() : input.frame.wayInWorld(seen.velocity);
    return {input.frame.pointInWorld(seen.position),
            velocity,
            state.ticks,
            seen.valid && state.unread <= kLostAfter,
            state.gate.anchoring(),
            coupling};
}

} // namespace

ServoState::ServoState(const DeviceInfo& device) noexcept
    : check(device), schedule(device), gate(device.tripSpeed), passivity(device), border(device),
      heat(device.maxForce, device.continuousForce), limiter{device.maxForce} {}

ServoOutput servoStep(ServoState& state, const ServoSettings& settings, const ServoInput& input,
                      const LocalContactModel& model_W) noexcept {
    const Previous previous = state.previous;
    const double dt = plausible(input.dt);
    const LocalContactModel model_D = inDevice(model_W, input.frame);
    ++state.ticks;
    const std::uint64_t shortened = state.limiter.clamped;

    // 1, 2  Reading and velocity: finite, and no faster than twice the trip speed.                    T12
    const DeviceSample& seen = validate(state, input, dt);

    // 3     Ceiling: what device, hand, period and delay bear, less what oscillations took.      T1, T4, T6
    const StiffnessBounds bounds = ceilingOf(state, previous, settings, input, model_D, dt);
    state.passivity.observe(seen.position, seen.velocity, dt);
    if (dt > kStall) state.passivity.notSent();
    state.limiter.maxForce = state.heat.limit();

    // 4, 5  Contact transition and spring: what is new comes in bounded in energy and rate.     T7, T8, T10
    const Contact contact = contactOf(state, model_D, seen, input.fresh, bounds, dt);

    // 6     Gate: off, settling, rising, on or latched, and why.                                    T9, T12
    const double gain = state.gate(gateInput(state, settings, input, model_D, contact, dt));

    // 7     Passivity: what was made is taken back, along the push alone and without a step.     T2, T3, T5
    RenderedSpring spring = damped(state, contact, seen.position, gain, dt);

    const Vec3 outside = outsideForce(previous.outside_D, gain > 0 ? input.outside_D : Vec3::Zero(),
                                      seen.velocity, state.limiter.maxForce, dt);

    // 8     Command check: what leaves is what is judged, in newtons a tick.                       T11, T12
    if (gain > 0 && !(suddenOf(state, previous, contact, seen.position, spring.force + gain * outside) <=
                      kForceJump * state.limiter.maxForce)) {
        state.gate.latch(spring.force.allFinite() ? InhibitReason::ForceJump : InhibitReason::NotFinite);
        spring = {};
    }

    // 9     Limit: finite, and at most what the motors bear now.                                        T12
    Vec3 force = state.limiter(spring.force + state.gate.gain() * outside);
    force += borderOf(state, input, seen.position, force, dt);
    spring.force = state.limiter(spring.force);
    state.heat.add(force.norm(), dt);
    state.passivity.commanded(spring);
    state.previous = {.finger_D = seen.position,
                      .anchor_D = contact.anchor.position,
                      .added_D = state.damper.force(),
                      .outside_D = state.gate.gain() > 0 ? outside : Vec3::Zero(),
                      .gain = state.gate.gain(),
                      .load = contact.model.stiffness * contact.stretch(seen.position),
                      .touching = contact.anchor.touching};
    return {.force = force,
            .finger = inWorld(state, input, couplingOf(state, settings, input, bounds, dt)),
            .frame = input.frame,
            .border = input.border,
            .limited = state.limiter.clamped != shortened};
}

} // namespace tactum
