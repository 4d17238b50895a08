#include "core/safety/guard.h"

#include <algorithm>

namespace tactum {
namespace {
/// In so long the finger may have gone around what it touched. Unit: s.
constexpr double kLongStall = 0.5;
} // namespace

/// Faults only count while there is a force to be taken away.
Withheld Guard::faultOf(const GuardInput& tick) noexcept {
    lateTicks_ = tick.late ? lateTicks_ + 1 : 0;
    if (tick.deviceLost) return Withheld::DeviceLost;
    if (tick.unguarded) return Withheld::Unguarded;
    if (!tick.finite) return Withheld::NotFinite;
    if (gain_ == 0) return Withheld::Nothing;
    if (tick.speed > tripSpeed_) return Withheld::TooFast;
    if (gain_ * tick.sudden > kForceJump * maxForce_) return Withheld::ForceJump;
    if (lateTicks_ > kLateTicks) return Withheld::Late;
    return Withheld::Nothing;
}

Withheld Guard::pauseOf(const GuardInput& tick) const noexcept {
    if (tick.stopped) return Withheld::Stopped;
    if (!tick.held) return Withheld::DeadMan;
    if (tick.clutched) return Withheld::Clutched;
    if (std::max(tick.dt, tick.unread) > kStall) return Withheld::Stall;
    if (!tick.answered) return Withheld::ProxySilent;
    return Withheld::Nothing;
}

void Guard::withhold(Withheld why) noexcept {
    if (why == Withheld::DeviceLost) ++anchoring_;
    if (isFault(why) && !isFault(why_)) ++faults_;
    why_ = why;
    gain_ = smallFor_ = 0;
}

void Guard::begin() noexcept {
    ++anchoring_;
    gain_ = smallFor_ = 0;
}

double Guard::operator()(const GuardInput& tick) noexcept {
    const Withheld fault = faultOf(tick);
    // A fault stays until the person has switched off and on again.
    if (!tick.armed) {
        if (why_ != Withheld::NotArmed) withhold(Withheld::NotArmed);
        return 0;
    }
    if (isFault(why_)) return 0;
    if (fault != Withheld::Nothing) {
        withhold(fault);
        return 0;
    }
    if (const Withheld pause = pauseOf(tick); pause != Withheld::Nothing) {
        if (tick.dt > kLongStall) ++anchoring_;
        withhold(pause);
        return 0;
    }
    if (gain_ == 0)
        settle(tick);
    else
        rise(tick);
    if (gain_ > 0) why_ = gain_ < 1 ? Withheld::Rising : Withheld::Nothing;
    return gain_;
}

void Guard::settle(const GuardInput& tick) noexcept {
    why_ = Withheld::Settling;
    smallFor_ = tick.wanted < kSmallForce ? smallFor_ + tick.dt : 0;
    if (smallFor_ >= kSmallForceTime) gain_ = kFirstGain;
}

void Guard::rise(const GuardInput& tick) noexcept {
    const double fastest = (1 - kFirstGain) / kRise;
    const double bearable = tick.wanted > 0 ? kRiseRate / tick.wanted : fastest;
    gain_ = std::min(1.0, gain_ + std::min(fastest, bearable) * tick.dt);
}

double Guard::arrivalDamping() const noexcept {
    return gain_ > 0 ? kArrivalDamping * (1 - gain_) / (1 - kFirstGain) : 0;
}

} // namespace tactum
