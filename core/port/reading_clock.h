// How far apart in time the readings of a device were measured.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/port/haptic_device.h"

namespace tactum {

/// A finger seems as fast as the time between two readings is short: that is neither the time between two
/// ticks, when an exchange takes long, nor any time at all, when a driver that ticks apart from the servo has
/// nothing new yet. Thread: real time.
class ReadingClock {
public:
    /// s from the valid reading before to this one; 0: it is that one once more. `elapsed`: s between the
    /// beginnings of the last two exchanges; `now`: ns of monotonicNanoseconds(), when this one came back.
    /// A reading that does not say when it was measured counts from where it makes the finger slowest: who
    /// holds the device still was not let go.
    double operator()(const DeviceSample& sample, double elapsed, std::int64_t now) noexcept {
        const double between = before_ == 0 ? elapsed : std::max(elapsed, 1e-9 * double(now - before_));
        before_ = now;
        waited_ += between;
        if (!sample.valid) return waited_;
        const double waited = waited_,
                     apart = sample.at != 0 && at_ != 0 ? apartFrom(sample, elapsed) : waited;
        at_ = sample.at;
        waited_ = 0;
        return apart;
    }

private:
    /// After a standstill the machine may have slept, which the clock of the readings does not count.
    double apartFrom(const DeviceSample& sample, double elapsed) const noexcept {
        constexpr double kStandstill = 0.01; // s
        if (sample.at <= at_) return 0;
        return std::max(1e-9 * double(sample.at - at_), elapsed > kStandstill ? elapsed : 0);
    }

    std::int64_t before_ = 0; ///< ns, when the last exchange came back
    std::int64_t at_ = 0;     ///< ns, of the newest valid reading
    double waited_ = 0;       ///< s, in exchanges since it
};

} // namespace tactum
