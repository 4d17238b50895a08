// The touch of a run as CSV: a row for each servo tick of an interval, or for every so many-th.
#pragma once

#include <optional>
#include <string>

#include "core/base/vec.h"

namespace tactum {

/// One servo tick. SI, world frame.
struct TouchTick {
    double t = 0; ///< s, of the clock of the servo
    Vec3 finger = Vec3::Zero(), proxy = Vec3::Zero();
    Vec3 force = Vec3::Zero(); ///< N, what the device was sent
    bool touching = false;
};

/// Makes rows of ticks. The velocity is that of the finger since the tick before, m/s, unfiltered; nothing is
/// written for the first tick after a gap. Thread: any but real time, one at a time.
class TouchLog {
public:
    explicit TouchLog(int every) : every_(every) {}

    static std::string header();
    /// Appends a row for the tick, when it is its turn. Trial and interval count from 1.
    void add(std::string& rows, const TouchTick& tick, int trial, int interval);
    /// The next tick follows no other: another interval began.
    void interrupt() { before_.reset(); }

private:
    int every_;
    int passed_ = 0; ///< ticks since the last row
    std::optional<TouchTick> before_;
};

} // namespace tactum
