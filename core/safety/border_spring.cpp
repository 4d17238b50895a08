#include "core/safety/border_spring.h"

#include <algorithm>

#include "core/safety/passivity.h"

namespace tactum {
namespace {
constexpr double kForgets = 0.02; ///< s, in which a way back is forgotten to a third; who did not move rests
constexpr double kAhead = 3; ///< times as far as in the last tick a hand may go in the next ones, at its turn
} // namespace

BorderSpring::BorderSpring(const DeviceInfo& device) noexcept
    : resolution_(device.positionResolution), delay_(ticksUntilFelt(device, kLongestDelay)) {
    commanded_.fill(Vec3::Zero());
}

/// A reading that goes to and fro between two counts is no work.
void BorderSpring::account(const Vec3& position, double dt) noexcept {
    step_ *= std::max(0.0, 1 - dt / kForgets);
    rested_ += dt;
    if (known_ && !((position - held_).norm() > 1.5 * resolution_)) return;
    if (known_) {
        const Vec3 way = position - held_;
        stored_ -= commanded_[std::size_t(delay_)].dot(way);
        back_ = held_.norm() - position.norm();
        step_ = std::max(step_, back_);
    }
    held_ = position;
    known_ = true;
    rested_ = 0;
}

/// N, of the commands that the device has not followed yet, added up.
double BorderSpring::onTheWay() const noexcept {
    double sum = 0;
    for (int i = 0; i < delay_; ++i)
        sum += commanded_[std::size_t(i)].norm();
    return sum;
}

Vec3 BorderSpring::operator()(const Vec3& position, double border, double limit, double dt) noexcept {
    account(position, dt);
    const double distance = position.norm(), depth = border > 0 ? distance - border : 0;
    if (!(depth > 0)) {
        stored_ = std::min(stored_, 0.0); // what was taken for ever is no credit
        return Vec3::Zero();
    }
    const double whole = std::min(kBorderStiffness * depth, kBorderMost * limit);
    const double stretched = whole * (depth - 0.5 * whole / kBorderStiffness); // J
    stored_ = rested_ > kForgets ? stretched : std::min(stored_, stretched);
    double force = whole;
    if (back_ > 0 && rested_ <= kForgets) {
        const double borne = (stored_ + kBorderCredit) / (kAhead * step_) - onTheWay();
        force = std::clamp(borne, 0.0, whole);
    }
    return -force / distance * position;
}

void BorderSpring::commanded(const Vec3& force) noexcept {
    std::copy_backward(commanded_.begin(), commanded_.end() - 1, commanded_.end());
    commanded_[0] = force;
}

} // namespace tactum
