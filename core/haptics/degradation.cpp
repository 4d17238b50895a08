#include "core/haptics/degradation.h"

#include <algorithm>

namespace tactum {
namespace {
constexpr double kWindow = 0.05;                         ///< s
constexpr double kCalm = 0.5;                            ///< of the budget
constexpr double kShortestWait = 0.5, kLongestWait = 16; ///< s
constexpr double kMaxPatience = 256;                     ///< s, of a level that fits and leaves little

Fidelity stepped(Fidelity fidelity, int by) noexcept {
    return Fidelity(int(fidelity) + by);
}
} // namespace

void DegradationController::stepDown(double now) noexcept {
    // A level that was just tried again was too much: the next try waits longer.
    const bool again = now - raisedAt_ < 2 * wait_;
    wait_ = again ? std::min(2 * wait_, kLongestWait) : kShortestWait;
    longWait_ = again ? std::min(2 * longWait_, kMaxPatience) : kLongestWait;
    fidelity_ = stepped(fidelity_, 1);
    ++stepsDown_;
    calmSince_ = fitsSince_ = now;
}

void DegradationController::stepUp(double now) noexcept {
    fidelity_ = stepped(fidelity_, -1);
    raisedAt_ = calmSince_ = fitsSince_ = now;
}

Fidelity DegradationController::operator()(double now, double took) noexcept {
    if (windowBegan_ < 0) windowBegan_ = calmSince_ = fitsSince_ = now;
    sum_ += took;
    ++count_;
    if (now - windowBegan_ < kWindow) return fidelity_;
    const double mean = sum_ / count_;
    windowBegan_ = now;
    sum_ = 0;
    count_ = 0;
    if (mean > kCalm * budget_) calmSince_ = now;
    if (mean > budget_) fitsSince_ = now;
    const bool mayStepUp = now - calmSince_ >= wait_ || now - fitsSince_ >= longWait_;
    if (mean > budget_ && fidelity_ < kMinFidelity)
        stepDown(now);
    else if (fidelity_ > Fidelity::Full && mayStepUp)
        stepUp(now);
    return fidelity_;
}

} // namespace tactum
