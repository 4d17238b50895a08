// What haptic devices there are on this machine, and whether this program can drive them.
#pragma once

#include <filesystem>

#include "core/control/device_catalogue.h"

namespace tactum {

/// The built-in devices first, then every known haptic device on the USB bus. `usbDevices` is the folder in
/// which the kernel lists them. Thread: any but real time.
std::vector<DeviceListing> listDevices(const std::filesystem::path& usbDevices = "/sys/bus/usb/devices");

} // namespace tactum
