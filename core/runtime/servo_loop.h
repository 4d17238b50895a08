// The loop that belongs to the device: its clock and its exchange around servoStep().
#pragma once

#include "core/loop/device_watchdog.h"
#include "core/loop/metronome.h"
#include "core/port/haptic_device.h"
#include "core/runtime/channels.h"

namespace tactum {

/// The heat that a device's motors were left with, and when: ns of monotonicNanoseconds().
struct LeftHeat {
    double heat = 0;
    std::int64_t at = 0;
};

/// Runs until channels.stop at the device's rate. The last command is zero. Every tick is a beat for the
/// device watchdog. A machine that slept stood still: the old force does not go out. `sinceBoot`: as of
/// Metronome. Motors do not cool because a loop ends: it begins with what is left of `motors`, and leaves its
/// own there. Thread: servo. Clock and device lie outside the RealtimeScope, all else inside it.
void servoLoop(HandChannels& channels, HapticDevice& device, const DeviceInfo& info, LeftHeat& motors,
               DeviceWatchdog& watchdog, Clock sinceBoot = bootNanoseconds) noexcept;

} // namespace tactum
