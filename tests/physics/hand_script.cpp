#include "tests/physics/hand_script.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tactum::test {

void HandScript::begin() {
    constexpr double kReach = 0.04;
    from_ = at_;
    kind_ = Kind(random_() % 4);
    time_ = 0;
    length_ = uniform(random_, 0.5, 3);
    depth_ = uniform(random_, 0.002, 0.02);
    hertz_ = kind_ == Kind::Tap ? uniform(random_, 2, 6) : uniform(random_, 0.3, 3);
    size_ = kind_ == Kind::Tap ? uniform(random_, 0.01, 0.03) : uniform(random_, 0.002, 0.02);
    size_ = std::min(size_, fastest_ / (2 * std::numbers::pi * hertz_));
    const Vec3 to(uniform(random_, -kReach, kReach), uniform(random_, -kReach, kReach), 0);
    way_ = to - Vec3(from_.x(), from_.y(), 0);
    if (kind_ != Kind::Line) way_.setZero();
}

// Each begins and ends smoothly.
Vec3 HandScript::goal(double dt) {
    time_ += dt;
    if (time_ >= length_) begin();
    const double part = time_ / length_, turn = 2 * std::numbers::pi * hertz_ * time_;
    const double ease = part * part * (3 - 2 * part), there = std::min(1.0, time_ / 0.2);
    at_ = from_ + ease * way_;
    at_.z() = from_.z() + there * (height_ - depth_ - from_.z());
    if (kind_ == Kind::Circle) at_ += there * size_ * Vec3(std::cos(turn), std::sin(turn), 0);
    if (kind_ == Kind::Tap) at_.z() += there * size_ * std::sin(turn);
    return at_;
}

} // namespace tactum::test
