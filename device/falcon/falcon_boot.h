// Gives the Falcon its firmware: TI's boot program at the other end of the line echoes every byte.
#pragma once

#include <cstdint>
#include <span>

#include "core/port/opening.h"
#include "device/usb/usb_link.h"

namespace tactum {

enum class FalconBoot : std::uint8_t {
    Done,      ///< the last byte was echoed: the device starts it by itself
    NoAnswer,  ///< of the boot program: it has no power, as a rule
    LostBytes, ///< on the way: the next attempt may be better
    Cancelled,
};

/// One attempt, from the reset to the last byte. `resetPause`: s, resetFalcon()'s. `cancellable`: whether the
/// watcher is asked. Errors: the link's. Thread: any but real time, for some seconds.
Result<FalconBoot> bootFalcon(UsbLink& link, std::span<const std::uint8_t> firmware, double resetPause,
                              Opening& watcher, bool cancellable);

} // namespace tactum
