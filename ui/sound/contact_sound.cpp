#include "ui/sound/contact_sound.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/vibration/vibration.h"

namespace tactum {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kPerNewton = 0.5;  // of full scale
constexpr double kFollowTime = 0.1; // s

double sinc(double x) {
    return std::abs(x) < 1e-9 ? 1 : std::sin(kPi * x) / (kPi * x);
}

} // namespace

ContactSound::ContactSound(double servoRate) {
    const double rate = std::clamp(servoRate, 100.0, double(kSoundRate));
    perSample_ = rate / kSoundRate;
    follow_ = 1 / (kFollowTime * rate);
    shaking_ = SecondOrder::highPass(kSlowestVibration, rate);
    for (int phase = 0; phase <= kPhases; ++phase) {
        // A sample lies between the two ticks in the middle of the taps.
        std::array<double, kTaps> taps{};
        double sum = 0;
        for (int i = 0; i < kTaps; ++i) {
            const double x = i - (kTaps / 2 - 1) - double(phase) / kPhases;
            const double window = 0.5 + 0.5 * std::cos(kPi * x / (0.5 * kTaps));
            taps[std::size_t(i)] = std::abs(x) < 0.5 * kTaps ? window * sinc(x) : 0;
            sum += taps[std::size_t(i)];
        }
        std::array<float, kTaps> row{};
        std::ranges::transform(taps, row.begin(), [sum](double tap) { return float(tap / sum); });
        kernel_.push_back(row);
    }
}

std::vector<float> ContactSound::operator()(std::span<const Vec3> forces) {
    std::vector<float> out;
    out.reserve(std::size_t(double(forces.size()) / perSample_) + 2);
    for (const Vec3& force : forces)
        tick(force, out);
    return out;
}

double ContactSound::shaking(const Vec3& force) {
    if (!begun_) shaking_.settle(force, Vec3::Zero());
    begun_ = true;
    const Vec3 now = shaking_(force);
    // Oja's rule: turns toward where the shaking is, by its power against that of the last moments.
    level_ += follow_ * (now.squaredNorm() - level_);
    if (direction_.isZero(0)) {
        if (now.norm() < 1e-9) return 0;
        direction_ = now.normalized();
    }
    const double along = now.dot(direction_);
    if (level_ > 1e-12)
        direction_ += std::min(0.5, follow_ * std::abs(along) * now.norm() / level_) * (along < 0 ? -1 : 1) *
                      (now / std::max(now.norm(), 1e-12));
    direction_.normalize();
    return now.dot(direction_);
}

void ContactSound::tick(const Vec3& force, std::vector<float>& out) {
    if (force.allFinite()) last_ = force;
    std::shift_left(recent_.begin(), recent_.end(), 1);
    recent_.back() = shaking(last_);
    for (; next_ < 1; next_ += perSample_) {
        const auto& taps = kernel_[std::size_t(std::lround(next_ * kPhases))];
        double sum = 0;
        for (std::size_t i = 0; i < kTaps; ++i)
            sum += double(taps[i]) * recent_[i];
        out.push_back(float(std::tanh(kPerNewton * sum)));
    }
    next_ -= 1;
}

} // namespace tactum
