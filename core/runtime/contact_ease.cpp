#include "core/runtime/contact_ease.h"

#include <algorithm>

namespace tactum {
namespace {

/// A model is carried on along its motion for no longer than a slow proxy loop takes. Unit: s.
constexpr double kOldest = 0.02;
constexpr double kThinnest = 1e-6; ///< m and m/s: what the rate of an edit is divided by

Vec3 shortened(const Vec3& v, double by) noexcept {
    const double length = v.norm();
    return length <= by ? Vec3::Zero() : Vec3(v * (1 - by / length));
}

double towards(double value, double target, double step) noexcept {
    return value + std::clamp(target - value, -step, step);
}

} // namespace

// The rendered proxy goes on from where it was; after a restart from the finger.
void ContactEase::meet(const LocalContactModel& newest, const Vec3& finger) noexcept {
    const bool restarted = !begun_ || newest.restarts != restarts_;
    const bool edited = newest.revision != revision_;
    if (restarted || edited) {
        const Anchor before = restarted ? Anchor{finger, false} : anchorOf(rendered_, finger);
        offset_ = before.position - anchorOf(newest, finger).position;
        editing_ = !restarted;
    }
    begun_ = true;
    restarts_ = newest.restarts;
    revision_ = newest.revision;
    age_ = 0;
}

void ContactEase::goOn(const LocalContactModel& newest, const Vec3& finger, const Vec3& velocity,
                       double ceiling, double dt) noexcept {
    const double stiffness = rendered_.stiffness, damping = rendered_.damping;
    rendered_ = newest;
    rendered_.proxy += offset_ + std::min(age_, kOldest) * newest.velocity;
    rendered_.stiffness = std::min(newest.stiffness, ceiling);
    if (!editing_) return;
    const Anchor anchor = anchorOf(rendered_, finger);
    const double depth = (anchor.position - finger).norm();
    const double target = rendered_.stiffness;
    rendered_.stiffness = towards(stiffness, target, kEditRate * dt / std::max(depth, kThinnest));
    rendered_.damping =
        towards(damping, newest.damping, kEditRate * dt / std::max(velocity.norm(), kThinnest));
    editing_ = rendered_.stiffness != target || rendered_.damping != newest.damping;
}

const LocalContactModel& ContactEase::operator()(const LocalContactModel& newest, bool fresh,
                                                 const Vec3& finger, const Vec3& velocity, double ceiling,
                                                 double dt) noexcept {
    age_ += dt;
    offset_ = shortened(offset_, kReturnSpeed * dt);
    if (fresh || !begun_) meet(newest, finger);
    goOn(newest, finger, velocity, ceiling, dt);
    // Nothing is touched: nothing is left to come back.
    if (newest.planes == 0) offset_ = Vec3::Zero();
    return rendered_;
}

} // namespace tactum
