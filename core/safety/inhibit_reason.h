// Why the device gets no force, or less of it: one list for the servo, the window and recordings.
#pragma once

#include <cstdint>

namespace tactum {

/// Latched ones stay until the person arms anew; pauses end by themselves.
enum class InhibitReason : std::uint8_t {
    Nothing,
    NotArmed,
    DeadMan,     ///< the switch that must be held is not
    Stall,       ///< the servo or the device stood still for more than kStall
    ProxySilent, ///< no model, or one that is too old
    Settling,    ///< waits until the proxy has answered and the force is small
    Rising,      ///< on its way back
    DeviceLost,  ///< readings that cannot be true, or none for kLostAfter
    TooFast,     ///< the finger was let go
    ForceJump,   ///< the command changed by more than surfaces and fingers can
    NotFinite,   ///< the command was no number
    Unguarded,   ///< nobody would stop the device if the program died
    Clutched,    ///< the person moves the device and not the finger
    Stopped,     ///< a button of the device has ended all force
};

inline constexpr std::size_t kInhibitReasons = std::size_t(InhibitReason::Stopped) + 1;

/// What cannot be true, or must not be: stays until the person arms anew.
constexpr bool isFault(InhibitReason why) noexcept {
    return why >= InhibitReason::DeviceLost && why <= InhibitReason::Unguarded;
}
/// What takes the force away and gives it back by itself.
constexpr bool isPause(InhibitReason why) noexcept {
    return why == InhibitReason::DeadMan || why == InhibitReason::Stall ||
           why == InhibitReason::ProxySilent || why == InhibitReason::Clutched ||
           why == InhibitReason::Stopped;
}

} // namespace tactum
