// Whether what a device says of itself can be true.
#pragma once

#include <string>

#include "core/port/haptic_device.h"

namespace tactum {

/// Rates that a servo can keep: at less than the first each tick would be a stall (kStall), and beyond the
/// second no computer wakes in time. Unit: Hz.
inline constexpr double kSlowestRate = 150, kFastestRate = 10'000;
/// The bits of DeviceSample::buttons that there may be.
inline constexpr int kMaxButtons = 31;

/// What one figure is and should be, "its rate is 0 Hz, and it must be from ..."; empty when all can be.
/// Thread: any but real time.
std::string impossibleFigure(const DeviceInfo& device);

/// A sentence about the first figure that cannot be. Every rule of the guard rests on these figures: a device
/// whose driver has them wrong is not used. Thread: any but real time.
Result<void> checkDevice(const DeviceInfo& device);

} // namespace tactum
