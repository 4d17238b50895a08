// Whether the device gets force at all: armed by the person, taken away by pauses and faults, brought back
// gently.
#pragma once

#include <cstdint>

#include "core/safety/inhibit_reason.h"

namespace tactum {

/// A reading that is older was overtaken by events: no force at once, and a soft return. Unit: s.
inline constexpr double kStall = 0.01;
/// A device that has sent nothing for so long is gone. Unit: s.
inline constexpr double kLostAfter = 1;
/// A force that was inhibited comes back over this time at least, beginning with kFirstGain. The gain rises,
/// not the force; it begins where a hand feels the surface and is not thrown yet. Unit: s.
inline constexpr double kRise = 0.6;
/// Under load a gain that rises stiffens the spring, which gives energy: it changes the force by no more than
/// this. Unit: N/s.
inline constexpr double kRiseRate = 10;
inline constexpr double kFirstGain = 0.15;
/// While the gain rises the finger is damped, with less and less. Unit: N s/m.
inline constexpr double kArrivalDamping = 8;
/// So long the force takes to go when nobody answers for it any more, who is not there to be hurt by a sudden
/// end. Unit: s.
inline constexpr double kFadeAway = 0.3;
/// Before it rises the force must have been smaller than this, a tenth of what a finger presses with, for so
/// long: one reading of a surface that damps may say so by accident. Units: N, s.
inline constexpr double kSmallForce = 0.2, kSmallForceTime = 0.02;

/// Off -> Settling -> Rising -> On; a pause leads back to Settling, a fault to Latched, disarming to Off. The
/// gain is above 0 in Rising and On alone; while it fades the state is Rising.
enum class GateState : std::uint8_t { Off, Settling, Rising, On, Latched };

/// What a tick brought.
struct GateInput {
    double dt = 1e-3;    ///< s since the last tick
    double unread = 0;   ///< s since the newest reading that was believed came; 0: at this tick
    bool armed = false;  ///< the person wants forces
    bool fading = false; ///< not armed any more, but the force goes over kFadeAway instead of at once
    bool held = true;    ///< the dead-man switch, or none is asked for
    bool clutched = false;
    bool stopped = false; ///< by a button, so that the device gets no force whatever comes out
    bool deviceLost = false;
    bool unguarded = false; ///< the watchdog of a real device is dead
    bool answered = false;  ///< the proxy knows where the finger is, and said so lately
    double speed = 0;       ///< of the finger, m/s
    double wanted = 0;      ///< magnitude of the force that the model asks for, N
    bool finite = true;     ///< of that force
};

/// The one state machine of the servo, with the reason beside it. SI. Thread: real time.
class ForceGate {
public:
    /// Of the device: m/s.
    explicit ForceGate(double tripSpeed) noexcept : tripSpeed_(tripSpeed) {}

    /// Decides about this tick and returns the gain of the force: 0 while it is inhibited, then rising to 1.
    double operator()(const GateInput& tick) noexcept;
    /// What only shows in the command itself: no force from now on.
    void latch(InhibitReason fault) noexcept;

    GateState state() const noexcept { return state_; }
    InhibitReason inhibit() const noexcept { return why_; }
    double gain() const noexcept { return gain_; }
    /// Of the damping that accompanies a rising gain: N s/m.
    double arrivalDamping() const noexcept;
    /// Raised when nobody knows which way the finger went: the proxy has to begin at the finger anew. After
    /// other pauses it goes on from where it is, and the contact begins without force (ContactTransition).
    std::uint32_t anchoring() const noexcept { return anchoring_; }
    std::uint64_t faults() const noexcept { return faults_; }
    /// The finger was put elsewhere: begin anew from there.
    void begin() noexcept;

    /// All that it remembers, for the recorder (core/base/byte_archive.h).
    static void fields(auto& visit, auto& self) {
        visit(self.tripSpeed_, self.state_, self.why_, self.gain_, self.smallFor_, self.anchoring_,
              self.faults_);
    }

private:
    InhibitReason faultOf(const GateInput& tick) const noexcept;
    void settle(InhibitReason why) noexcept;
    void wait(const GateInput& tick) noexcept;
    void rise(const GateInput& tick) noexcept;
    double disarmed(const GateInput& tick) noexcept;
    bool fades(const GateInput& tick) noexcept;

    double tripSpeed_;
    GateState state_ = GateState::Off;
    InhibitReason why_ = InhibitReason::NotArmed;
    double gain_ = 0;
    double smallFor_ = 0; ///< s
    std::uint32_t anchoring_ = 0;
    std::uint64_t faults_ = 0;
};

} // namespace tactum
