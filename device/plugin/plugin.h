// Drivers of other people's: shared libraries with the C functions of tactum_driver.h.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/port/device_catalogue.h"

namespace tactum {

/// Where they are looked for, in this order: the folders of TACTUM_DRIVERS, divided by colons; without it
/// ~/.local/share/Tactum/drivers (or below XDG_DATA_HOME). Thread: any but real time.
std::vector<std::filesystem::path> driverFolders();

/// One for each device that they find, "driver:LIBRARY:PORT"; one that is not usable and says what to do for
/// each library that is none. Loads them all: whoever must not crash asks in another process. Thread: any but
/// real time, one at a time.
std::vector<DeviceListing> listPlugins();

/// The device with such an id. Its figures are those that its driver says. Error: no such id, or not there
/// any more. Thread: as listPlugins().
Result<std::unique_ptr<HapticDevice>> makePlugin(const std::string& id);

} // namespace tactum
