// What happened in a recording, in words: for the scrubber and for `tactum play`.
#pragma once

#include <string>
#include <vector>

#include "core/runtime/recorded_run.h"

namespace tactum {

struct RecordedEvent {
    double time = 0; ///< s on the clock of the rows
    bool fault = false;
    std::string text; ///< a few words; of one of several hands they begin with which
};

/// Read from the rows, in the order of time: faults and other pauses of the force, forces on and off,
/// oscillations, edits of the scene, proxies that were put elsewhere, readings that failed.
/// Thread: any but real time.
std::vector<RecordedEvent> eventsOf(const RecordedRun& run);

} // namespace tactum
