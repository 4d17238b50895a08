// Talking with the Falcon before its stream begins: the settings of its USB chip, and one question at a time.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "device/falcon/falcon_packet.h"
#include "device/usb/usb_link.h"

namespace tactum {

inline constexpr UsbId kFalconUsb{0x0403, 0xcb48};
inline constexpr UsbEndpoints kFalconEndpoints{};

/// The serial line between chip and processor. Its rate is a divisor in the chip's own code; the timer is how
/// long the chip keeps an answer that does not fill a packet.
struct FalconLine {
    std::uint16_t rate = 0;
    std::uint16_t timer = 1; ///< ms
};
inline constexpr FalconLine kFalconBootLine{0x4138, 16}; ///< 9600 baud; with a shorter timer it tends to fail
inline constexpr FalconLine kFalconLoadLine{0x0015, 16}; ///< 142857 baud
inline constexpr FalconLine kFalconRunLine{0x0002, 1};   ///< 1.5 Mbaud

// Errors: the link's. Thread of all: any but real time; not while the stream runs.

/// Forgets what is on its way in the chip, both ways.
Result<void> purgeFalcon(UsbLink& link);
Result<void> setFalconLine(UsbLink& link, const FalconLine& line);
/// The edge of DTR from low to high puts the processor back into its boot program. `pause`: s, that it is
/// low.
Result<void> resetFalcon(UsbLink& link, double pause);
Result<void> releaseFalconReset(UsbLink& link);

/// What the processor said next; empty when nothing came within one packet or `patience`.
Result<std::vector<std::uint8_t>> hearFalcon(UsbLink& link, std::chrono::milliseconds patience);

/// Sends a command and waits for its report, 50 ms at most; nullopt: none came.
Result<std::optional<FalconReport>> askFalcon(UsbLink& link, const FalconCommand& command);

} // namespace tactum
