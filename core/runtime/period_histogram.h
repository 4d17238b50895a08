// How regular a loop's ticks are: counts of their deviations, for the display.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace tactum {

/// How many ticks deviated from their period by up to each bound. Thread: real time, one thread only.
struct PeriodHistogram {
    /// Microseconds, each bin's upper end; the last bin has none.
    static constexpr std::array<double, 11> kBounds{2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000};

    std::array<std::uint32_t, kBounds.size() + 1> count{};
    double longest = 0; ///< microseconds that the longest period was longer than it should be

    /// `deviation` in microseconds, of a period that was too short below 0.
    void add(double deviation) noexcept {
        std::size_t bin = 0;
        while (bin < kBounds.size() && std::abs(deviation) > kBounds[bin])
            ++bin;
        ++count[bin];
        longest = std::max(longest, deviation);
    }
    /// The bound below which a part of the ticks lies, in microseconds; for the last bin twice its begin: it
    /// has none.
    double quantile(double part) const noexcept {
        std::uint64_t all = 0, seen = 0;
        for (const std::uint32_t n : count)
            all += n;
        for (std::size_t bin = 0; bin < kBounds.size(); ++bin)
            if (double(seen += count[bin]) >= part * double(all)) return kBounds[bin];
        return 2 * kBounds.back();
    }
};

/// The ticks of the last kPeriodWindow seconds, and of as many before them: what a loop was like hours ago
/// tells nothing of now. Thread: real time, one thread only.
class RecentPeriods {
public:
    static constexpr double kPeriodWindow = 5; ///< s

    /// `now` in s, never falling; the rest as above.
    void add(double now, double deviation) noexcept {
        if (now - begin_ >= kPeriodWindow) {
            older_ = now - begin_ < 2 * kPeriodWindow ? newer_ : PeriodHistogram{};
            newer_ = {};
            begin_ = now;
        }
        newer_.add(deviation);
    }
    PeriodHistogram counted() const noexcept {
        PeriodHistogram both = older_;
        for (std::size_t bin = 0; bin < both.count.size(); ++bin)
            both.count[bin] += newer_.count[bin];
        both.longest = std::max(both.longest, newer_.longest);
        return both;
    }

private:
    PeriodHistogram older_, newer_;
    double begin_ = 0; ///< s, of newer_
};

} // namespace tactum
