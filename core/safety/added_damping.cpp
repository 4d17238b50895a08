#include "core/safety/added_damping.h"

#include <algorithm>

namespace tactum {
namespace {
constexpr double kGone = 2.5; ///< times as fast as it may grow: all of it within six ticks of 1 kHz
} // namespace

Vec3 AddedDamping::operator()(const Vec3& push, const Vec3& brake, const Vec3& sliding, double limit,
                              double dt) noexcept {
    const double strength = push.norm();
    const bool touching = strength > 0;
    if (touching) out_ = push / strength;
    // What would give energy, or is left of a contact.
    const bool over = !touching || force_.dot(sliding) > 0;
    const double most = kMaxAddedForce * limit;
    const Vec3 wanted = over ? Vec3::Zero() : Vec3(std::clamp(brake.dot(out_), -most, most) * out_);
    const double step = (over ? kGone : 1) * kAddedRate * limit * dt;
    const Vec3 way = wanted - force_;
    const double length = way.norm();
    force_ = length > step ? Vec3(force_ + step / length * way) : wanted;
    return force_;
}

} // namespace tactum
