#include "core/safety/added_damping.h"

#include <algorithm>

namespace tactum {
namespace {
constexpr double kGone = 2.5; ///< times as fast as it may grow
} // namespace

Vec3 AddedDamping::operator()(const Vec3& push, const Vec3& brake, const Vec3& sliding, double limit,
                              double dt) noexcept {
    const double strength = push.norm();
    const bool touching = strength > 0;
    if (touching) out_ = push / strength;
    const double most = kMaxAddedForce * limit;
    const double wanted = touching ? std::clamp(brake.dot(out_), -most, most) : 0;
    // What would give energy, or is left of a contact, goes faster than it came, and yet without a step.
    const bool over = !touching || added_ * sliding.dot(out_) > 0;
    const double step = (over ? kGone : 1) * kAddedRate * limit * dt;
    added_ += std::clamp((over ? 0 : wanted) - added_, -step, step);
    return force();
}

} // namespace tactum
