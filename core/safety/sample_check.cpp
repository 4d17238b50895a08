#include "core/safety/sample_check.h"

#include <algorithm>

namespace tactum {
namespace {
/// A period is judged as no shorter than this: readings that come in pairs are not refused. Unit: s.
constexpr double kShortestTime = 1e-3;
} // namespace

bool SampleCheck::canBeTrue(const DeviceSample& sample, double since) const noexcept {
    if (!sample.valid || !sample.position.allFinite() || !sample.velocity.allFinite()) return false;
    if (good_ == 0 && !believed_.valid) return true;
    if (sample.jumped) return true;
    const double way = (sample.position - believed_.position).norm();
    return way <= fastest_ * std::max(since, kShortestTime);
}

bool SampleCheck::operator()(const DeviceSample& sample, double apart) noexcept {
    if (sample.valid && apart == 0) {
        believed_.jumped = sample.jumped; // a decision about the workspace may fall on it
        return bad_ == 0;
    }
    if (sample.valid) since_ += apart;
    if (!canBeTrue(sample, since_)) {
        ++refused_;
        good_ = 0;
        // None at all is late, or the end of the device: time tells (ForceGate). It is no lie, but it clears
        // none up either.
        if ((sample.valid || bad_ > 0) && ++bad_ >= kBadSamplesToLoss) lost_ = true;
        if (lost_) believed_.valid = false;
        believed_.velocity = Vec3::Zero(); // of a finger that is not seen to move
        believed_.jumped = false;
        return false;
    }
    const bool first = !believed_.valid;
    if (++good_ >= kBadSamplesToLoss) lost_ = false;
    believed_ = sample;
    believed_.jumped = sample.jumped || first;
    believed_.valid = !lost_;
    if (!measuresVelocity_) believed_.velocity = estimate_(sample.position, believed_.jumped, since_);
    since_ = 0;
    bad_ = 0;
    return true;
}

} // namespace tactum
