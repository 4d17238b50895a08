// Any device in a process of its own: what its driver does to memory, it does to that process.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/port/haptic_device.h"

namespace tactum {

/// Starts `program` with `arguments`, which has to call serveDevice() (device/remote/serve_device.h), and
/// asks it for the device's figures. The device answers a tick later than in the program itself. A driver
/// that crashes or stands still gives invalid readings within kOldestReading, and a sentence; open() starts
/// it anew. Thread: any but real time.
Result<std::unique_ptr<HapticDevice>> makeRemoteDevice(const std::filesystem::path& program,
                                                       const std::vector<std::string>& arguments);

/// That this program has at the moment. Thread: any.
int countRemoteDevices();

} // namespace tactum
