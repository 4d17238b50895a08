// Whether the device gets force at all: armed by the person, taken away by faults, brought back gently.
#pragma once

#include <cstdint>

namespace tactum {

/// Why no force, or less of it, goes to the device. What isFault() stays so until the person arms anew.
enum class Withheld : std::uint8_t {
    Nothing,
    NotArmed,
    DeadMan,     ///< the switch that must be held is not
    Stall,       ///< the servo or the device stood still for more than kStall
    ProxySilent, ///< no model, or one that is too old
    Settling,    ///< waits until the proxy has answered and the force is small
    Rising,      ///< on its way back
    DeviceLost,  ///< readings that cannot be true, or none
    TooFast,     ///< the finger was let go
    ForceJump,   ///< the wanted force changed by more than surfaces and fingers can
    NotFinite,   ///< the wanted force was no number
    Late,        ///< the servo missed tick after tick
    Unguarded,   ///< nobody would stop the device if the program died
    Clutched,    ///< the person moves the device and not the finger
    Stopped,     ///< a button of the device has ended all force
};

inline bool isFault(Withheld why) noexcept {
    return why >= Withheld::DeviceLost && why <= Withheld::Unguarded;
}
/// What takes the force away and gives it back by itself.
inline bool isPause(Withheld why) noexcept {
    return why == Withheld::DeadMan || why == Withheld::Stall || why == Withheld::ProxySilent ||
           why == Withheld::Clutched || why == Withheld::Stopped;
}

/// A reading that is older was overtaken by events: no force at once, and a soft return. Unit: s.
inline constexpr double kStall = 0.01;
/// A force that was withheld comes back over this time at least, beginning with kFirstGain. The gain rises,
/// not the force. Unit: s.
inline constexpr double kRise = 0.6;
/// Under load a gain that rises stiffens the spring, which gives energy: it changes the force by no more than
/// this. Unit: N/s.
inline constexpr double kRiseRate = 10;
inline constexpr double kFirstGain = 0.15;
/// While the gain rises the finger is damped, with less and less. Unit: N s/m.
inline constexpr double kArrivalDamping = 8;
/// Before it rises the force must have been smaller than this for so long. Units: N, s.
inline constexpr double kSmallForce = 0.2, kSmallForceTime = 0.02;
/// The wanted force must not change by more than this part of the device's limit from tick to tick beyond
/// what the finger itself explains; only what it pushes less counts for nothing.
inline constexpr double kForceJump = 0.6;
/// So many late ticks in a row are a fault.
inline constexpr int kLateTicks = 5;

/// What a tick brought.
struct GuardInput {
    double dt = 1e-3;   ///< s since the last tick
    double unread = 0;  ///< s since the newest reading that was believed came; 0: at this tick
    bool late = false;  ///< the tick came more than one period late
    bool armed = false; ///< the person wants forces
    bool held = true;   ///< the dead-man switch, or none is asked for
    bool clutched = false;
    bool stopped = false; ///< by a button, so that the device gets no force whatever comes out
    bool deviceLost = false;
    bool unguarded = false; ///< the guardian of a real device is dead
    bool answered = false;  ///< the proxy knows where the finger is, and said so lately
    double speed = 0;       ///< of the finger, m/s
    double wanted = 0;      ///< magnitude of the force that the model asks for, N
    double sudden = 0;      ///< how much of it is new, reversed or aside, and not the finger's doing, N
    bool finite = true;     ///< of that force
};

/// The state of the guard: off, settling, rising, on, or a fault that stays. Thread: real time.
class Guard {
public:
    /// Limits of the device: N, m/s.
    Guard(double maxForce, double tripSpeed) noexcept : maxForce_(maxForce), tripSpeed_(tripSpeed) {}

    /// Decides about this tick and returns the gain of the force: 0 while it is withheld, then rising to 1.
    double operator()(const GuardInput& tick) noexcept;

    Withheld withheld() const noexcept { return why_; }
    double gain() const noexcept { return gain_; }
    /// Of the damping that accompanies a rising gain: N s/m.
    double arrivalDamping() const noexcept;
    /// Raised when nobody knows which way the finger went: the proxy has to begin at the finger anew. After
    /// other pauses it goes on from where it is, and the contact begins without force (ContactEase).
    std::uint32_t anchoring() const noexcept { return anchoring_; }
    std::uint64_t faults() const noexcept { return faults_; }
    /// The finger was put elsewhere: begin anew from there.
    void begin() noexcept;

    /// All that it remembers, for the recorder (core/base/byte_archive.h).
    static void fields(auto& visit, auto& self) {
        visit(self.maxForce_, self.tripSpeed_, self.why_, self.gain_, self.smallFor_, self.lateTicks_,
              self.anchoring_, self.faults_);
    }

private:
    Withheld faultOf(const GuardInput& tick) noexcept;
    Withheld pauseOf(const GuardInput& tick) const noexcept;
    void withhold(Withheld why) noexcept;
    void settle(const GuardInput& tick) noexcept;
    void rise(const GuardInput& tick) noexcept;

    double maxForce_, tripSpeed_;
    Withheld why_ = Withheld::NotArmed;
    double gain_ = 0;
    double smallFor_ = 0; ///< s
    int lateTicks_ = 0;
    std::uint32_t anchoring_ = 0;
    std::uint64_t faults_ = 0;
};

} // namespace tactum
