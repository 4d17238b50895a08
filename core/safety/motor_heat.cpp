#include "core/safety/motor_heat.h"

#include <algorithm>
#include <cmath>

namespace tactum {
MotorHeat::MotorHeat(double maxForce, double continuousForce) noexcept
    : max_(maxForce), continuous_(continuousForce > 0 ? std::min(continuousForce, maxForce) : maxForce) {}

void MotorHeat::add(double force, double dt) noexcept {
    if (!(continuous_ > 0)) return;
    const double ratio = force / continuous_;
    heat_ += (ratio * ratio - heat_) * -std::expm1(-dt / kMotorTime);
}

void MotorHeat::resume(double heat, double seconds) noexcept {
    heat_ = heat * std::exp(-std::max(seconds, 0.0) / kMotorTime);
}

double MotorHeat::limit() const noexcept {
    const double cool = std::clamp((1 - heat_) / (1 - kWarmMotors), 0.0, 1.0);
    return continuous_ + (max_ - continuous_) * cool;
}

} // namespace tactum
