#include "core/safety/contact_transition.h"

#include <algorithm>
#include <cmath>

namespace tactum {
namespace {

/// A model is carried on along its motion for no longer than a slow proxy loop takes. Unit: s.
constexpr double kOldest = 0.02;
constexpr double kSoftest = 2, kWeakest = 0.03; ///< N/m and N, of what is about to be gone
constexpr int kCorrections = kMaxModelPlanes;   ///< each brings one plane to where it was
constexpr double kThinnest = 1e-6;              ///< m, m/s and N: what a rate is divided by

Vec3 shortened(const Vec3& v, double by) noexcept {
    const double length = v.norm();
    return length <= by ? Vec3::Zero() : Vec3(v * (1 - by / length));
}

Vec3 atMost(const Vec3& v, double most) noexcept {
    return shortened(v, std::max(0.0, v.norm() - most));
}

double towards(double value, double target, double step) noexcept {
    return value + std::clamp(target - value, -step, step);
}

/// The coefficient of friction that keeps the finger's anchor at the model's proxy.
double gripNeeded(const LocalContactModel& model, const Vec3& finger) noexcept {
    const NearestPoint nearest =
        nearestPoint(finger - model.proxy, {model.plane.data(), std::size_t(model.planes)});
    double most = 0;
    for (int i = 0; i < model.planes; ++i)
        most = std::max(most, nearest.lambda[i]);
    return most > 0 ? nearest.x.norm() / most : 0;
}

/// Along a plane.
Vec3 along(const ConstraintPlane& plane, const Vec3& v) noexcept {
    return v - plane.normal.dot(v) * plane.normal;
}

LocalContactModel moved(const LocalContactModel& model, const Vec3& by) noexcept {
    LocalContactModel result = model;
    result.proxy += by;
    return result;
}

/// N/m, of what is rendered and what is wanted.
double stifferOf(const LocalContactModel& rendered, const LocalContactModel& newest,
                 const TransitionBounds& bounds) noexcept {
    return std::max(rendered.stiffness, std::min(newest.stiffness, bounds.ceiling));
}

} // namespace

double editRate(double stiffness) noexcept {
    return std::min(kEditRate, kReturnSpeed * std::abs(stiffness)); // a rate, whatever a model says
}

// A slide against viscosity goes on for as long as the model is believed at all: one that stopped before
// would leave the anchor behind, and the next answer would bring what it had not slid as a pull.
double ContactTransition::since(double dt) const noexcept {
    return std::min(age_ + dt, kModelPatience);
}

// A proxy that was put elsewhere begins at the finger, without force.
void ContactTransition::meet(const LocalContactModel& newest, const Vec3& finger,
                             const TransitionBounds& bounds, double dt) noexcept {
    const Anchor before = begun_ ? anchorOf(rendered_, finger, since(dt)) : Anchor{finger, false};
    age_ = 0;
    if (!before.touching) { // nothing is under load: no value needs a ramp
        rendered_ = newest;
        rendered_.stiffness = std::min(newest.stiffness, bounds.ceiling);
    }
    const bool edited = newest.revision != revision_ || newest.restarts != restarts_;
    if (!begun_ || (edited && !before.touching)) {
        offset_ = finger - anchorOf(newest, finger).position;
        heldBack_ = 0;
        slip_ = Vec3::Zero();
        editing_ = false;
        hold_ = 0;
    } else if (edited) {
        edit(newest, before.position, finger);
    } else {
        catchUp(newest);
        handOver(newest, before.position, finger, bounds, dt);
        if (before.touching) turn(newest, before.position, finger, bounds, dt);
    }
    begun_ = true;
    restarts_ = newest.restarts;
    revision_ = newest.revision;
}

// The surroundings stay with the anchor as far as the energy that they add to the spring is not paid for.
// Planes that meet at an angle take more than one correction. An answer that came a tick later than the one
// after it makes a body that moves by itself seem to stand and then to leap: its work of one tick is free.
void ContactTransition::handOver(const LocalContactModel& newest, const Vec3& before, const Vec3& finger,
                                 const TransitionBounds& bounds, double dt) noexcept {
    const double stiffness = stifferOf(rendered_, newest, bounds);
    const double own = stiffness * std::max(0.0, (before - finger).dot(motion_) * dt);
    for (int i = 0;; ++i) {
        const Vec3 after = anchorOf(byNow(newest), finger, since(dt)).position;
        const double gained =
            0.5 * stiffness * ((after - finger).squaredNorm() - (before - finger).squaredNorm()) - own;
        if (gained <= credit_ || i == kCorrections) {
            credit_ -= std::max(gained, 0.0);
            return;
        }
        offset_ += before - after;
        heldBack_ += (before - after).norm();
    }
}

// Off the rim of a sheet, or out of one pocket into the next, the proxy comes nearer to the finger and may
// yet push it the other way: no energy is brought, and still it would be a kick. What surroundings that are
// left were off by is none of the new ones' either.
void ContactTransition::turn(const LocalContactModel& newest, const Vec3& before, const Vec3& finger,
                             const TransitionBounds& bounds, double dt) noexcept {
    const double felt = bounds.force / stifferOf(rendered_, newest, bounds);
    const Vec3 was = atMost(before - finger, felt);
    const Vec3 now = atMost(anchorOf(byNow(newest), finger, since(dt)).position - finger, felt);
    if (!(rise(now, was) > kMaxTurn * felt)) return;
    const Vec3 stretch = anchorOf(newest, finger, since(dt)).position - finger;
    const double length2 = stretch.squaredNorm();
    const double kept = length2 > 0 ? std::clamp(was.dot(stretch) / length2, 0.0, 1.0) : 0;
    offset_ = (kept - 1) * stretch;
    heldBack_ = 0;
    slip_ = Vec3::Zero();
}

/// What the true proxy slips by itself, the rendered one has slipped before.
void ContactTransition::catchUp(const LocalContactModel& newest) noexcept {
    if (slip_.isZero(0)) return;
    const Vec3 way = newest.proxy - (rendered_.proxy - offset_ - slip_);
    const double length = slip_.norm(), caughtUp = std::clamp(way.dot(slip_) / length, 0.0, length);
    slip_ *= 1 - caughtUp / length;
    slip_ = newest.planes == 1 ? along(newest.plane[0], slip_) : Vec3(Vec3::Zero());
}

// Surroundings on their way back are met less deep than the true ones: the rendered proxy slips where the
// true one sticks. If it slipped back as they return, it would pull the finger to where the true one stuck.
void ContactTransition::slipOn(const LocalContactModel& newest, const Vec3& finger, double dt) noexcept {
    if (offset_.isZero(0) && slip_.isZero(0)) return;
    const Anchor rendered = anchorOf(rendered_, finger, since(dt));
    if (!rendered.touching) slip_ = Vec3::Zero();
    if (!rendered.touching || rendered_.planes != 1) return;
    LocalContactModel truth = moved(rendered_, -offset_ - slip_);
    truth.friction = newest.friction;
    const ConstraintPlane& plane = rendered_.plane[0];
    const Vec3 seen = along(plane, rendered.position - rendered_.proxy);
    const double length = seen.norm();
    const double real = along(plane, anchorOf(truth, finger, since(dt)).position - truth.proxy).norm();
    if (!(length > real)) return;
    const Vec3 more = (1 - real / length) * seen;
    slip_ += more;
    rendered_.proxy += more;
}

// Where a body was moved, or grew over the proxy, the proxy begins anew; but what pushes the finger the same
// way is the same body to the hand, and to let it sink in first would be a fall.
bool ContactTransition::lost(const LocalContactModel& newest, const Vec3& finger) const noexcept {
    if (newest.restarts == restarts_ && newest.revision == revision_) return false;
    const Anchor rendered = anchorOf(rendered_, finger), next = anchorOf(newest, finger);
    const bool goesOn = next.touching && (next.position - finger).dot(rendered.position - finger) > 0;
    return rendered.touching && !goesOn;
}

// Around the last edge, or out on the far side: what pushed is gone in one step of the proxy, or pushes the
// other way.
bool ContactTransition::fell(const LocalContactModel& newest, const Vec3& finger,
                             const TransitionBounds& bounds, double dt) const noexcept {
    const Vec3 was = anchorOf(rendered_, finger, since(dt)).position - finger;
    const Vec3 now = anchorOf(byNow(newest), finger, since(dt)).position - finger;
    return rendered_.stiffness * was.norm() > kMaxTurn * bounds.force && now.dot(was) <= 0;
}

// It becomes softer as it does in an edit, until next to nothing is left; what was left by the finger's own
// way, and what the device does not bear, goes as fast as in any other contact.
void ContactTransition::leave(const Vec3& finger, double ceiling, double dt) noexcept {
    const double depth = (anchorOf(rendered_, finger, since(dt)).position - finger).norm();
    const auto softer = [&](double rate) {
        return rendered_.stiffness - rate * dt / std::max(depth, kThinnest);
    };
    const double slowly = fallen_ ? kSurfaceRate : editRate(rendered_.stiffness);
    rendered_.stiffness = std::min(softer(slowly), std::max(ceiling, softer(kSurfaceRate)));
    rendered_.damping = 0;
    rendered_.velocity = motion_ = Vec3::Zero(); // it stands where it was last
    leaving_ = rendered_.stiffness > kSoftest && rendered_.stiffness * depth > kWeakest;
    begun_ = leaving_;
}

void ContactTransition::edit(const LocalContactModel& newest, const Vec3& anchor,
                             const Vec3& finger) noexcept {
    offset_ = anchor - newest.proxy;
    heldBack_ = 0;
    slip_ = Vec3::Zero();
    editing_ = true;
    hold_ = gripNeeded(moved(newest, offset_), finger);
}

/// A body of which nothing was heard for too long stands still.
Vec3 ContactTransition::motionOf(const LocalContactModel& newest) const noexcept {
    return age_ < kOldest ? newest.velocity : Vec3(Vec3::Zero());
}

/// The model where it is by now, but for the stiffness.
LocalContactModel ContactTransition::byNow(const LocalContactModel& newest) const noexcept {
    LocalContactModel model = moved(newest, offset_ + slip_ + std::min(age_, kOldest) * newest.velocity);
    model.velocity = motionOf(newest);
    if (!offset_.isZero(0)) model.velocity -= kReturnSpeed * offset_.normalized();
    for (FrictionLimit& friction : model.friction)
        friction.coefficient = std::max(friction.coefficient, hold_);
    return model;
}

// From what was rendered before to what is wanted now, by no more force in a time than the hand bears.
void ContactTransition::approach(const LocalContactModel& before, const Vec3& finger, const Vec3& velocity,
                                 double ceiling, double dt) noexcept {
    const LocalContactModel wanted = rendered_;
    const double stiffness = std::min(wanted.stiffness, ceiling);
    const double depth = (anchorOf(rendered_, finger, since(dt)).position - finger).norm();
    const double change = (editing_ ? editRate(before.stiffness) : kSurfaceRate) * dt;
    rendered_.stiffness = towards(before.stiffness, stiffness, change / std::max(depth, kThinnest));
    if (!editing_) return;
    rendered_.damping =
        towards(before.damping, wanted.damping, change / std::max(velocity.norm(), kThinnest));
    hold_ = std::max(0.0, hold_ - change / std::max(rendered_.stiffness * depth, kThinnest));
    editing_ = rendered_.stiffness != stiffness || rendered_.damping != wanted.damping || hold_ > 0;
}

const LocalContactModel& ContactTransition::operator()(const LocalContactModel& newest, bool fresh,
                                                       const Vec3& finger, const Vec3& velocity,
                                                       const TransitionBounds& bounds, double dt) noexcept {
    age_ += dt;
    credit_ = std::min(kHandOverEnergy, credit_ + kHandOverPower * dt);
    const Vec3 left = shortened(offset_, kReturnSpeed * dt);
    rendered_.proxy += left - offset_ + motion_ * dt;
    offset_ = left;
    heldBack_ = std::clamp(heldBack_ - kReturnSpeed * dt, 0.0, left.norm());
    fallen_ =
        begun_ && (leaving_ ? fallen_ : fresh && !lost(newest, finger) && fell(newest, finger, bounds, dt));
    leaving_ = begun_ && (leaving_ || fallen_ || lost(newest, finger));
    if (leaving_) leave(finger, bounds.leaving, dt);
    if (leaving_) return rendered_;
    if (fresh || !begun_) meet(newest, finger, bounds, dt);
    const LocalContactModel before = rendered_;
    rendered_ = byNow(newest);
    motion_ = motionOf(newest);
    approach(before, finger, velocity, bounds.ceiling, dt);
    slipOn(newest, finger, dt);
    // Nothing is touched: nothing is left to come back.
    if (newest.planes == 0) {
        offset_ = slip_ = Vec3::Zero();
        hold_ = 0;
    }
    return rendered_;
}

} // namespace tactum
