// Touch, Touch X and the Phantoms, by 3D Systems' own library where the user has it. Never tried with either.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/port/device_catalogue.h"

namespace tactum {

/// One for each device that was set up, "openhaptics:NAME"; one that is not usable and says what to install
/// where the library is missing. Thread: any but real time.
std::vector<DeviceListing> listOpenHaptics();

/// The device with such an id, "openhaptics:default" the maker's default. Of its `figures`
/// the limits are lowered to what the device says of itself. Only one at a time. Error: no such id.
/// Thread: any but real time.
Result<std::unique_ptr<HapticDevice>> makeOpenHaptics(const std::string& id, FiguresOf figures);

} // namespace tactum
