#include "core/control/passivity.h"

#include <algorithm>

namespace tactum {
namespace {
/// Above what quantised positions make the observer err: (Delta / 2) (TV(F) + F_max). Unit: J.
constexpr double kThreshold = 1e-3;
constexpr double kMost = 5e-3;      ///< J, that is remembered at most
constexpr double kForgotten = 1e-3; ///< J/s; more than that a hand takes without notice
constexpr double kMostDamping = 8;  ///< N s/m; more would shake a light device at 1 kHz itself
constexpr double kSlowest = 1e-3;   ///< m/s; a finger at rest takes no energy out
} // namespace

// Friction along each axis, as its joints have it; of all axes together it is at least that of the way.
void Passivity::observe(const Vec3& position, const Vec3& velocity, double dt) noexcept {
    const double taken = (ownDamping_ * velocity.norm() + friction_) * velocity.norm() * dt;
    if (known_) given_ += spring_.force.dot(position - last_ - spring_.velocity * dt) - taken;
    given_ = std::clamp(given_, -spring_.stored - kThreshold, kMost - spring_.stored);
    if (energy() > 0) given_ -= std::min(energy(), kForgotten * dt);
    last_ = position;
    known_ = true;
}

double Passivity::damping(double stored, const Vec3& velocity, double dt) noexcept {
    damping_ = 0;
    const double speed2 = velocity.squaredNorm();
    const double excess = given_ + stored - kThreshold;
    if (excess > 0 && speed2 > kSlowest * kSlowest)
        damping_ = std::min(kMostDamping, excess / (speed2 * dt));
    return damping_;
}

void Passivity::commanded(const RenderedSpring& spring) noexcept {
    spring_ = spring;
}

} // namespace tactum
