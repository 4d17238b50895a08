// How late this machine wakes a loop like the servo's.
#pragma once

#include <array>
#include <cstdint>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/loop/urgency.h"

namespace tactum {

/// How late the ticks of a loop were. Thread: one at a time.
class LatencyHistogram {
public:
    /// s, from 0 on. Thread: real time.
    void add(double late) noexcept;

    std::uint64_t ticks() const noexcept { return ticks_; }
    double worst() const noexcept { return worst_; } ///< s
    /// s, that at least this part of the ticks (0 to 1) were not later than, to a microsecond; from 20 ms on
    /// the worst.
    double quantile(double part) const noexcept;
    /// How many were later than so many s, which is at most 20 ms.
    std::uint64_t laterThan(double seconds) const noexcept;

private:
    static constexpr std::size_t kBins = 20'000;  ///< microseconds
    std::array<std::uint32_t, kBins + 1> bins_{}; ///< the last: later than all
    std::uint64_t ticks_ = 0;
    double worst_ = 0;
};

struct LatencyReport {
    double rate = 0;  ///< Hz
    Urgency urgency;  ///< what the loop was granted
    int unlocked = 0; ///< errno of lockPresentMemory()
    LatencyHistogram late;
};

/// Runs a loop that does nothing at this rate (Hz) for so many seconds, with the priority that the servo asks
/// for. Ends early where `progress` says so, with what there is. Thread: any but real time.
Result<LatencyReport> measureLatency(double rate, double seconds, const Progress& progress);

} // namespace tactum
