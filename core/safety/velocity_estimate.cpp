#include "core/safety/velocity_estimate.h"

#include <algorithm>
#include <cmath>

namespace tactum {

bool VelocityEstimate::fits(int axis, int length, double slope) const noexcept {
    for (int i = 1; i < length; ++i) {
        const Reading& reading = past_[std::size_t(i)];
        const double line = past_[0].position[axis] - slope * reading.age;
        if (std::abs(reading.position[axis] - line) > resolution_) return false;
    }
    return true;
}

double VelocityEstimate::slope(int axis) const noexcept {
    double best = 0;
    for (int length = 1; length < length_; ++length) {
        const Reading& first = past_[std::size_t(length)];
        const double slope = (past_[0].position[axis] - first.position[axis]) / first.age;
        if (length > 1 && !fits(axis, length, slope)) break;
        best = slope;
        if (!(resolution_ > 0)) break;
    }
    return best;
}

Vec3 VelocityEstimate::operator()(const Vec3& position, bool jumped, double dt) noexcept {
    if (jumped) length_ = 0;
    std::copy_backward(past_.begin(), past_.end() - 1, past_.end());
    for (Reading& reading : past_)
        reading.age += dt;
    past_[0] = {position, 0};
    length_ = std::min(length_ + 1, kWindow + 1);
    return {slope(0), slope(1), slope(2)};
}

} // namespace tactum
