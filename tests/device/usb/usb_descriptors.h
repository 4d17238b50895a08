// What an emulated device says of itself in the bytes of the USB specification (chapter 9).
#pragma once

#include <optional>

#include "tests/device/usb/emulated_usb.h"

namespace tactum::test {

/// The device descriptor and after it the one configuration, as in the file `descriptors` of sysfs.
Bytes descriptorBytes(const UsbDescription& description);
/// Answers the requests that every device knows; nullopt when it is none of them.
std::optional<Bytes> standardAnswer(const UsbDescription& description, const UsbSetup& setup);

} // namespace tactum::test
