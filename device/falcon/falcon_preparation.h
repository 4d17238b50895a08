// From a Falcon somewhere on the bus to one that answers and knows where its grip is.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/port/opening.h"
#include "device/usb/usb_link.h"

namespace tactum {

std::vector<std::string> falconSteps();

/// Whether it answers and is homed, asked without force. Thread: any but real time.
bool isFalconReady(UsbLink& link);

/// Looks for it in the socket of `place`, else for the only one there is, and notes where it was found; loads
/// the firmware if it does not run already; waits until the person has homed it. No torque is ever sent. What
/// needs the person fails when the watcher has given up before it began: nobody watches then.
/// Errors name the step and what to do. Thread: a worker, for as long as the person takes.
Result<std::unique_ptr<UsbLink>> prepareFalcon(UsbPlace& place, const std::filesystem::path& firmware,
                                               double resetPause, Opening& watcher);

} // namespace tactum
