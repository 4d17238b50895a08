#include "core/control/passivity.h"

#include <algorithm>

namespace tactum {
namespace {
/// Above what quantised positions make the observer err: (Delta / 2) (TV(F) + F_max). Unit: J.
constexpr double kThreshold = 1e-3;
constexpr double kMostDamping = 8; ///< N s/m; more would shake a light device at 1 kHz itself
constexpr double kSlowest = 1e-3;  ///< m/s; a finger at rest takes no energy out
} // namespace

void Passivity::observe(const Vec3& position) noexcept {
    if (known_) energy_ += force_.dot(position - last_);
    last_ = position;
    known_ = true;
}

Vec3 Passivity::damped(const Vec3& force, const Vec3& velocity, double dt) noexcept {
    damping_ = 0;
    const double speed2 = velocity.squaredNorm();
    const double excess = energy_ + force.dot(velocity) * dt - kThreshold;
    if (excess <= 0 || speed2 < kSlowest * kSlowest) return force;
    damping_ = std::min(kMostDamping, excess / (speed2 * dt));
    return force - damping_ * velocity;
}

void Passivity::commanded(const Vec3& force, bool touching, double stored) noexcept {
    force_ = force;
    energy_ = touching ? std::max(energy_, -stored - kThreshold) : 0;
}

} // namespace tactum
