// The touch of a run as CSV: a row for each servo tick of an interval, or for every so many-th.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/runtime/trace_point.h"

namespace tactum {

/// What a tick is logged with besides itself. Counts are from 1.
struct TouchMoment {
    int trial = 1, interval = 1;
    int hand = 1;
    std::string_view condition{};  ///< its name
    std::optional<double> value{}; ///< of a staircase's parameter, in its unit
    const Scene* scene = nullptr;  ///< that the tick's World is of, for names; null: it is not known
};

/// Makes rows of ticks. The velocity is that of the finger since the tick before, m/s, unfiltered; nothing is
/// written for the first tick after a gap. Thread: any but real time, one at a time.
class TouchLog {
public:
    explicit TouchLog(int every) : every_(every) {}

    static std::string header();
    /// Appends a row for the tick, when it is its turn.
    void add(std::string& rows, const TracePoint& tick, const TouchMoment& moment);
    /// The next tick follows no other: another interval began.
    void interrupt() { before_.reset(); }

private:
    /// Of the tick before.
    struct Before {
        double t = 0;
        Vec3 finger = Vec3::Zero();
    };

    int every_;
    int passed_ = 0; ///< ticks since the last row
    std::optional<Before> before_;
};

} // namespace tactum
