#include "core/safety/passivity.h"

#include <algorithm>
#include <cmath>

namespace tactum {
namespace {
constexpr double kMax = 2 * kSofteningThreshold; ///< J, that is remembered at most
constexpr double kForgotten = 2e-4;              ///< J/s; more than that a hand takes without notice
/// Of the device's losses: a swing that they alone keep from growing must be noticed too. More than
/// seven tenths, below which nothing of the tests swings at all (docs/stability.md).
constexpr double kCredit = 0.75;
constexpr double kMaxDamping = 8; ///< N s/m; more would shake a light device at 1 kHz itself
constexpr double kAtRest = 1e-3;  ///< m/s; a finger at rest takes no energy out
constexpr double kRest = 0.01;    ///< s; at the turn of a swing it is shorter
} // namespace

int ticksUntilFelt(const DeviceInfo& device, int most) noexcept {
    constexpr double kRounding = 1e-6; // 0.0005 s at 2000 Hz are one tick and not two
    const double late = device.delay + device.amplifierLag * device.rate;
    return int(std::ceil(std::max(0.0, std::min(double(most), late)) - kRounding));
}

double RenderedSpring::stored() const noexcept {
    const double rendered = stiffness * stretch > limit ? limit / stiffness : stretch;
    return stiffness * rendered * (stretch - 0.5 * rendered);
}

Passivity::Passivity(const DeviceInfo& device) noexcept
    : ownDamping_(device.damping), friction_(device.dryFriction), resolution_(device.positionResolution),
      delay_(ticksUntilFelt(device, kLongestDelay)) {}

void Passivity::notice(const Vec3& position, double dt) noexcept {
    const bool left = (position - rest_).cwiseAbs().maxCoeff() > 1.5 * resolution_;
    if (left) rest_ = position;
    restedFor_ = left ? 0 : restedFor_ + dt;
}

bool Passivity::resting() const noexcept {
    return restedFor_ > kRest;
}

/// J: the reading of a resting finger that goes to and fro between two counts seems to make (Delta / 2) |dF|
/// each time.
double Passivity::noise() const noexcept {
    return resting() ? 0.5 * resolution_ * (commanded_[0].force - commanded_[1].force).norm() : 0;
}

// Friction along each axis, as its joints have it; of all axes together it is at least that of the way.
void Passivity::observe(const Vec3& position, const Vec3& velocity, double dt) noexcept {
    const double taken = kCredit * (ownDamping_ * velocity.norm() + friction_) * velocity.norm() * dt;
    const RenderedSpring& felt = commanded_[std::size_t(delay_)];
    const Vec3 way = position - last_ - felt.velocity * dt;
    notice(position, dt);
    if (energy() > 0) given_ -= std::min(energy(), kForgotten * dt);
    const double work = felt.force.dot(way) - taken - noise();
    if (known_ && std::isfinite(work)) given_ += work; // what is no number would stay for ever
    last_ = position;
    known_ = true;
}

/// J, that the spring holds more because it was made stiffer.
double Passivity::granted(const RenderedSpring& spring) const noexcept {
    RenderedSpring before = spring;
    before.stiffness = std::min(spring.stiffness, commanded_[0].stiffness);
    return spring.stored() - before.stored();
}

double Passivity::damping(const RenderedSpring& spring, const Vec3& velocity, double dt) noexcept {
    damping_ = 0;
    const double speed2 = velocity.squaredNorm();
    const double excess = given_ + spring.stored() - granted(spring);
    taking_ = excess > (taking_ ? 0 : kPassivityThreshold);
    if (taking_ && !resting() && speed2 > kAtRest * kAtRest)
        damping_ = std::min(kMaxDamping, excess / (speed2 * dt));
    return damping_;
}

// Only with the spring that answers the reading is the balance one: before, it is short of what the spring
// took up on the way in, which at speed is more than it may remember at all.
void Passivity::commanded(const RenderedSpring& spring) noexcept {
    given_ -= granted(spring);
    stored_ = spring.stored();
    given_ = std::clamp(given_, -stored_ - kPassivityThreshold, kMax - stored_);
    std::copy_backward(commanded_.begin(), commanded_.end() - 1, commanded_.end());
    commanded_[0] = spring;
}

} // namespace tactum
