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

/// What of one hand is recorded: states at the beginning and now and then, and every row of both loops.
struct HandRecord {
    DeviceInfo device;
    NumberedRows<ProxyRow> proxy;
    NumberedRows<ServoRow> servo;
    std::vector<SimStateBytes> proxyStates; ///< numbers rise; the first row has one unless its number is 0
    std::vector<ServoStateBytes> servoStates;
};

/// A stretch of time that can be stepped through again: the hands, and the scenes that they felt. The states
/// of the first hand hold what all share, too.
struct RecordedRun : HandRecord {
    std::vector<HandRecord> others;    ///< the second hand and so on; their steps are those of the first
    std::vector<RecordedScene> scenes; ///< each revision once

    std::size_t hands() const { return 1 + others.size(); }
    /// i < hands().
    const HandRecord& hand(std::size_t i) const { return i == 0 ? *this : others[i - 1]; }
    HandRecord& hand(std::size_t i) { return i == 0 ? *this : others[i - 1]; }
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
