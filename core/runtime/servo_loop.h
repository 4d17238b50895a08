// The loop that belongs to the device: reads the finger, renders the local contact model, limits, commands.
#pragma once

#include "core/control/haptic_device.h"
#include "core/runtime/channels.h"

namespace tactum {

/// A model that the proxy loop has not renewed for so long is no longer believed: zero force. Unit: s.
inline constexpr double kModelPatience = 0.1;
/// A force that was withheld, for whatever reason, comes back over this time. The gain rises, not the force:
/// limiting the rate of the force itself inside the loop makes limit cycles. Unit: s.
inline constexpr double kForceReturn = 0.25;

/// Runs until channels.stop at the device's rate. The last command is zero.
/// Thread: servo. Clock and device lie outside the RealtimeScope, all else inside it.
void servoLoop(Channels& channels, HapticDevice& device, const DeviceInfo& info) noexcept;

} // namespace tactum
