// omega, delta, sigma and lambda, by Force Dimension's own library where the user has it. Never tried with
// either.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/port/device_catalogue.h"

namespace tactum {

/// One for each that is connected, "forcedimension:INDEX"; one that is not usable and says what to install
/// where the library is missing, or that nothing is connected. While one of them is open here the others are
/// not asked for their names. Thread: any but real time.
std::vector<DeviceListing> listForceDimension();

/// The device with such an id. Torques and the force of a gripper stay zero. The
/// servo calls the library itself, which waits for the transfer. Error: no such id. Thread: any but real
/// time.
Result<std::unique_ptr<HapticDevice>> makeForceDimension(const std::string& id, FiguresOf figures);

} // namespace tactum
