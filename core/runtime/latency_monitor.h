// Tells the machine's delays from our own, by the processor time that a loop itself used.
#pragma once

#include <cstdint>

#include "core/loop/metronome.h"

namespace tactum {

/// A tick that was missed is the loop's own doing when its work took so long that nobody could have been in
/// time. Otherwise the processor was given to others, or the device kept its exchange waiting: no program
/// could have avoided it. Costs one look at a clock in each tick. Thread: the loop's, real time.
class LatencyMonitor {
public:
    /// `used`: the thread's processor time until now; for tests, another clock than the machine's.
    explicit LatencyMonitor(Clock used = threadNanoseconds) noexcept : used_(used), before_(used()) {}

    /// Call once at every tick, with the nominal period in s. Whether a miss of this tick is the loop's own.
    bool isOwn(double period) noexcept {
        const std::int64_t worked = used_() - before_;
        before_ += worked;
        return 1e-9 * double(worked) > kMissed * period;
    }

private:
    /// Work that begins with a tick and takes so many periods comes a whole period late to the next.
    static constexpr double kMissed = 2;

    Clock used_;
    std::int64_t before_; ///< ns
};

} // namespace tactum
