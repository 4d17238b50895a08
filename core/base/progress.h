// How long work says where it is and is told to stop.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>

#include "core/base/result.h"

namespace tactum {

/// How long work tells where it is and is told to stop. Both may be empty.
struct Progress {
    std::function<void(double fraction)> report; ///< 0 to 1, called from the working thread
    const std::atomic<bool>* cancelled = nullptr;
    bool isCancelled() const { return cancelled && cancelled->load(std::memory_order_relaxed); }
};

/// The same work seen as the part from `low` to `high` of a longer one.
inline Progress partOf(const Progress& whole, double low, double high) {
    Progress part;
    part.cancelled = whole.cancelled;
    if (whole.report)
        part.report = [report = whole.report, low, high](double f) { report(low + f * (high - low)); };
    return part;
}

/// What cancelled work answers.
inline tl::unexpected<Error> cancelledError() {
    return inputError("cancelled");
}

/// Watches one loop: a comparison on most turns, a look at the Progress on few.
class ProgressMeter {
public:
    /// `every`: turns (items, bytes) between two looks, chosen to be some 10 ms of work.
    ProgressMeter(const Progress& progress, std::size_t total, std::size_t every = 1 << 16)
        : progress_(progress), total_(std::max<std::size_t>(total, 1)), every_(every), next_(every) {}

    /// False when the work is to stop. `done` of `total` turns are behind.
    bool goesOn(std::size_t done) { return done < next_ || look(done); }

private:
    bool look(std::size_t done) {
        next_ = done + every_;
        if (progress_.report) progress_.report(std::min(1.0, double(done) / double(total_)));
        return !progress_.isCancelled();
    }

    const Progress& progress_;
    std::size_t total_, every_, next_;
};

} // namespace tactum
