#include "core/vibration/pad_motors.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/vibration/vibration.h"

namespace tactum {
namespace {

/// s. Long enough for the slowest vibration to be one strength, and for no more.
constexpr double kFollowTime = 0.02;

double told(double newtons, double strength) {
    return std::sqrt(std::clamp(newtons * strength, 0.0, 1.0));
}

} // namespace

PadMotors::PadMotors(double rate)
    : tick_(1 / std::clamp(rate, kLowestRate, kHighestRate)), follow_(1 - std::exp(-tick_ / kFollowTime)),
      shaking_(SecondOrder::highPass(kSlowestVibration, 1 / tick_)),
      low_(SecondOrder::lowPass(kSplit, 1 / tick_)), high_(SecondOrder::highPass(kSplit, 1 / tick_)) {}

void PadMotors::rest() {
    settle(Vec3::Zero());
    untouched_ = 0;
    begun_ = false;
    last_.setZero();
}

/// As if this force had been there for ever.
void PadMotors::settle(const Vec3& force) {
    shaking_.settle(force, Vec3::Zero());
    for (SecondOrder* each : {&low_, &high_})
        each->settle(Vec3::Zero(), Vec3::Zero());
    lowPower_ = highPower_ = pulse_ = impact_ = 0;
}

void PadMotors::tick(const Vec3& force, bool touching) {
    if (force.allFinite()) last_ = force;
    if (!std::exchange(begun_, true)) settle(last_);
    if (touching && untouched_ >= kApart) {
        pulse_ = kPulse;
        impact_ = 0;
    }
    untouched_ = touching ? 0 : std::min(kApart, untouched_ + tick_);
    if (untouched_ >= kRelease) return settle(Vec3::Zero());
    pulse_ = std::max(0.0, pulse_ - tick_);
    impact_ = std::max(impact_, last_.norm());
    const Vec3 shaking = shaking_(last_);
    lowPower_ += follow_ * (low_(shaking).squaredNorm() - lowPower_);
    highPower_ += follow_ * (high_(shaking).squaredNorm() - highPower_);
}

MotorStrengths PadMotors::strengths(double strength) const {
    const double impact = pulse_ > 0 ? impact_ : 0;
    const auto of = [&](double power) { return told(std::max(std::sqrt(2 * power), impact), strength); };
    return {of(lowPower_), of(highPower_)};
}

} // namespace tactum
