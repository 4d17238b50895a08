// The clock of a loop: wakes it at a fixed rate, says how late it was, and keeps its statistics.
#pragma once

#include <cstdint>
#include <limits>

#include "core/base/clock.h"
#include "core/port/haptic_device.h"

namespace tactum {

/// Nanoseconds of a clock. Thread: real time.
using Clock = std::int64_t (*)() noexcept;

/// One waking of a loop. Unit: s.
struct Tick {
    double time = 0;       ///< since the metronome was made, without the time that the machine slept
    double elapsed = 0;    ///< since the waking before, asleep or not; the nominal period at the first
    double late = 0;       ///< since it was due
    bool missed = false;   ///< more than one period late
    std::int64_t woke = 0; ///< ns of CLOCK_MONOTONIC
    bool asleep = false;   ///< before it was due: the work of before did not make it late
    bool framed = false;   ///< it is a device's frame, and not one of the loop's own clock
};

/// Sleeps to absolute times, so that errors do not add up, and never spins: a loop that cannot keep its
/// rate still sleeps for `rest` of the time it worked. (A thread that asks for all of a processor under
/// SCHED_FIFO is stopped by the kernel for 50 ms in every second.)
class Metronome {
public:
    /// rate in Hz, > 0; rest a ratio, 0 for a loop that waits for a device anyway. `sinceBoot`: for tests,
    /// another one than the machine's.
    explicit Metronome(double rate, double rest = 0, Clock sinceBoot = bootNanoseconds) noexcept;

    /// Sleeps until the next tick. A tick that was missed shifts the ones after it: no burst catches up.
    /// Thread: the loop's, outside every RealtimeScope.
    Tick wait() noexcept;
    /// The same, but the frames of a device that can tell of them are the ticks, however fast they come: up
    /// to four times the rate, and where none comes half a period late.
    Tick wait(HapticDevice& device) noexcept;

    double period() const noexcept; ///< s, nominal

private:
    std::int64_t asleep() noexcept;
    Tick wakeUp(std::int64_t due, bool sleeping, bool framed) noexcept;

    std::int64_t period_, start_, last_, scheduled_;
    double rest_;
    Clock sinceBoot_;
    /// ns, that it is ahead of the clock that stands still; before the first look far behind
    std::int64_t slept_ = std::numeric_limits<std::int64_t>::min() / 2;
};

/// How often something happened and how large it was, over the last full half second.
/// Thread: real time, one thread only.
class HalfSecond {
public:
    /// One event: `now` in s, never falling; `value` in any unit.
    void add(double now, double value) noexcept;

    /// Nothing could happen until now: what was counted is not part of a half second.
    void begin(double now) noexcept;

    double rate() const noexcept { return rate_; } ///< events a second; 0 in the first half second
    double mean() const noexcept { return mean_; }
    double worst() const noexcept { return worst_; }

private:
    double begin_ = 0, sum_ = 0, largest_ = 0;
    std::uint32_t count_ = 0;
    double rate_ = 0, mean_ = 0, worst_ = 0;
};

} // namespace tactum
