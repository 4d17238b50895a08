// Haply's Inverse3 and Minverse, by the Inverse Service that runs on this machine. Never tried with either.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/port/device_catalogue.h"

namespace tactum {

/// One for each that the service tells of, "haply:ID"; one that is not usable and says what to do where there
/// is none. Waits for some tenths of a second at most. Thread: any but real time.
std::vector<DeviceListing> listHaply();

/// The device with such an id. `profile`: its figures. Error: no such id. Thread: any but real time.
Result<std::unique_ptr<HapticDevice>> makeHaply(const std::string& id, DeviceInfo profile);

} // namespace tactum
