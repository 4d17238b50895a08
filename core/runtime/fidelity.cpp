#include "core/runtime/fidelity.h"

#include <algorithm>

namespace tactum {
namespace {
constexpr double kWindow = 0.05;                         ///< s
constexpr double kCalm = 0.5;                            ///< of the budget
constexpr double kShortestWait = 0.5, kLongestWait = 16; ///< s

Fidelity stepped(Fidelity fidelity, int by) noexcept {
    return Fidelity(int(fidelity) + by);
}
} // namespace

void OverloadLadder::stepDown(double now) noexcept {
    // A level that was just tried again was too much: the next try waits longer.
    wait_ = now - raisedAt_ < 2 * wait_ ? std::min(2 * wait_, kLongestWait) : kShortestWait;
    fidelity_ = stepped(fidelity_, 1);
    ++stepsDown_;
    calmSince_ = now;
}

void OverloadLadder::stepUp(double now) noexcept {
    fidelity_ = stepped(fidelity_, -1);
    raisedAt_ = calmSince_ = now;
}

Fidelity OverloadLadder::operator()(double now, double took) noexcept {
    if (windowBegan_ < 0) windowBegan_ = calmSince_ = now;
    sum_ += took;
    ++count_;
    if (now - windowBegan_ < kWindow) return fidelity_;
    const double mean = sum_ / count_;
    windowBegan_ = now;
    sum_ = 0;
    count_ = 0;
    if (mean > kCalm * budget_) calmSince_ = now;
    if (mean > budget_ && fidelity_ < kLeastFidelity)
        stepDown(now);
    else if (fidelity_ > Fidelity::Full && now - calmSince_ >= wait_)
        stepUp(now);
    return fidelity_;
}

} // namespace tactum
