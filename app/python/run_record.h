// The last minute of a World that is stepped by Python, as a recording that the program plays.
#pragma once

#include <memory>

#include "core/recording/recording_file.h"

namespace tactum::python {

/// Keeps every step as the flight recorder keeps those of the loops. Thread: one at a time.
class RunRecord {
public:
    RunRecord();

    /// Before a step in `world`: gives the row its time, and keeps the state now and then, which empties its
    /// memories as the loops do.
    void begin(ProxyRow& row, SimState& state, const World& world);
    /// After it.
    void end(const ProxyRow& row);
    /// The last minute, without the servo, which there was none of.
    Recording recording(const std::string& reason) const;

private:
    RecordedRun run_;
    double time_ = 0, stateDue_ = kStateEvery; ///< s since the first step
};

} // namespace tactum::python
