// Whether the rows of a file can be stepped from, with its device. For this folder only.
#pragma once

#include <string>

#include "core/runtime/recorded_run.h"

namespace tactum {

/// What is wrong with them, and with which; empty when nothing is. Rows that no live run can have would keep
/// a player busy for ever: times that fall, and a run much longer than what is kept. Readings of the device
/// may be anything: the guard of the servo is there for them.
std::string faultIn(const RecordedRun& run);

} // namespace tactum
