// What the flight recorder kept of a stretch of time: enough to step through it again.
#pragma once

#include <memory>
#include <vector>

#include "core/base/record_ring.h"
#include "core/runtime/recorded_step.h"
#include "core/runtime/state_bytes.h"

namespace tactum {

/// How much is kept, and how often a state. Unit: s.
inline constexpr double kRecorded = 60, kStateEvery = 1;

/// A Scene as it was felt under a World's revision.
struct RecordedScene {
    WorldNumbers numbers;
    std::shared_ptr<const Scene> scene;
};

/// A stretch of time that can be stepped through again: states at its beginning and now and then in it, every
/// row of both loops, and the scenes that they felt.
struct RecordedRun {
    DeviceInfo device;
    std::vector<RecordedScene> scenes; ///< each revision once
    NumberedRows<ProxyRow> proxy;
    NumberedRows<ServoRow> servo;
    std::vector<SimStateBytes> proxyStates; ///< numbers rise; the first row has one unless its number is 0
    std::vector<ServoStateBytes> servoStates;

    /// nullptr when there is none of this revision.
    const RecordedScene* sceneOf(std::uint64_t revision) const;
    /// s, on the clock of the rows; 0 for both when nothing was recorded.
    double begin() const;
    double end() const;
};

/// Leaves out what cannot be replayed, because the state, a row or the scene before it is gone, and what is
/// older than `seconds`. Thread: any but real time.
void trim(RecordedRun& run, double seconds = kRecorded);

} // namespace tactum
