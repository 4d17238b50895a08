// The last act before the device, for what is no force on the finger.
#pragma once

#include "core/port/haptic_device.h"

namespace tactum {

/// The same, at most DeviceInfo::maxTorque and maxPinch; zero where it is no number. Thread: real time.
HandleCommand heldTo(const DeviceInfo& device, const HandleCommand& wanted) noexcept;

} // namespace tactum
