// Whether the rows of a file can be stepped from, with its device. For this folder only.
#pragma once

#include "core/runtime/recorded_run.h"

namespace tactum {

/// What is wrong with them; nullptr when nothing is. Readings of the device may be anything: the guard of the
/// servo is there for them.
const char* faultIn(const RecordedRun& run);

} // namespace tactum
