#include "core/safety/force_gate.h"

#include <algorithm>

namespace tactum {
namespace {

/// What ends by itself.
InhibitReason pauseOf(const GateInput& tick) noexcept {
    if (tick.stopped) return InhibitReason::Stopped;
    if (!tick.held) return InhibitReason::DeadMan;
    if (tick.clutched) return InhibitReason::Clutched;
    if (std::max(tick.dt, tick.unread) > kStall) return InhibitReason::Stall;
    if (!tick.answered) return InhibitReason::ProxySilent;
    return InhibitReason::Nothing;
}

} // namespace

/// A finger that is fast is a fault only while there is a force to be taken away.
InhibitReason ForceGate::faultOf(const GateInput& tick) const noexcept {
    if (tick.deviceLost || tick.unread > kLostAfter) return InhibitReason::DeviceLost;
    if (tick.unguarded) return InhibitReason::Unguarded;
    if (!tick.finite) return InhibitReason::NotFinite;
    if (gain_ > 0 && tick.speed > tripSpeed_) return InhibitReason::TooFast;
    return InhibitReason::Nothing;
}

double ForceGate::operator()(const GateInput& tick) noexcept {
    if (!tick.armed) return disarmed(tick);
    if (state_ == GateState::Latched) return 0; // until the person has switched off and on again
    if (const InhibitReason fault = faultOf(tick); fault != InhibitReason::Nothing) {
        latch(fault);
    } else if (const InhibitReason pause = pauseOf(tick); pause != InhibitReason::Nothing) {
        settle(pause);
    } else if (state_ == GateState::Off || state_ == GateState::Settling) {
        wait(tick);
    } else {
        rise(tick);
    }
    return gain_;
}

/// What cuts a fade short is told in the tick in which it does, as every pause is.
double ForceGate::disarmed(const GateInput& tick) noexcept {
    if (fades(tick)) return gain_;
    const InhibitReason pause = tick.fading && gain_ > 0 ? pauseOf(tick) : InhibitReason::Nothing;
    settle(pause == InhibitReason::Nothing ? InhibitReason::NotArmed : pause);
    state_ = GateState::Off;
    return 0;
}

void ForceGate::settle(InhibitReason why) noexcept {
    state_ = GateState::Settling;
    why_ = why;
    gain_ = smallFor_ = 0;
}

void ForceGate::latch(InhibitReason fault) noexcept {
    settle(fault);
    state_ = GateState::Latched;
    if (fault == InhibitReason::DeviceLost) ++anchoring_;
    ++faults_;
}

void ForceGate::begin() noexcept {
    ++anchoring_;
    if (state_ == GateState::Rising || state_ == GateState::On) settle(InhibitReason::Settling);
    gain_ = smallFor_ = 0;
}

void ForceGate::wait(const GateInput& tick) noexcept {
    const double smallFor = tick.wanted < kSmallForce ? smallFor_ + tick.dt : 0;
    settle(InhibitReason::Settling);
    smallFor_ = smallFor;
    if (smallFor_ < kSmallForceTime) return;
    gain_ = kFirstGain;
    state_ = GateState::Rising;
    why_ = InhibitReason::Rising;
}

void ForceGate::rise(const GateInput& tick) noexcept {
    const double fastest = (1 - kFirstGain) / kRise;
    const double bearable = tick.wanted > 0 ? kRiseRate / tick.wanted : fastest;
    gain_ = std::min(1.0, gain_ + std::min(fastest, bearable) * tick.dt);
    if (gain_ < 1) return;
    state_ = GateState::On;
    why_ = InhibitReason::Nothing;
}

/// A spring that gets softer takes energy and gives none. Armed again, the gain rises from where it is.
bool ForceGate::fades(const GateInput& tick) noexcept {
    if (!tick.fading || faultOf(tick) != InhibitReason::Nothing || pauseOf(tick) != InhibitReason::Nothing)
        return false;
    const double left = gain_ - tick.dt / kFadeAway;
    if (!(left > 0)) return false;
    gain_ = left;
    state_ = GateState::Rising;
    why_ = InhibitReason::NotArmed;
    return true;
}

double ForceGate::arrivalDamping() const noexcept {
    return gain_ > 0 && why_ != InhibitReason::NotArmed ? kArrivalDamping * (1 - gain_) / (1 - kFirstGain)
                                                        : 0;
}

} // namespace tactum
