// The other side of a remote device: the process in which the driver runs.
#pragma once

#include "core/port/haptic_device.h"

namespace tactum {

/// The first of the two descriptors that such a process inherits.
extern const int kServeDescriptor;

/// Does what the program asks through the descriptor until the program says nothing more: it ended, of
/// whatever cause. From open() to close() a loop of its own exchanges at the device's rate. The device gets
/// no force once the program died; one that stands still for kOldestCommand loses its force over
/// kCommandFade. A crash of this process, of any signal, brings the device to zero too: by the handler of the
/// signal, and by a device watchdog. Returns the exit code of the process, the device closed. Thread: main.
int serveDevice(HapticDevice& device, int descriptor);

/// For a program that cannot make the device it is asked for: the sentence goes to who asked.
int refuseToServe(const Error& error, int descriptor);

} // namespace tactum
