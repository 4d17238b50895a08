#include "app/library/stepped_world.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tactum::library {
namespace {

constexpr double kShortest = 1e-6, kLongest = 1; ///< s
constexpr double kFarthestPlace = 1e6;           ///< m
constexpr double kFastest = 1e13;                ///< m/s, more than the farthest way in the shortest time

::tactum::Vec3 eigen(const Vec3& v) noexcept {
    return {v.x, v.y, v.z};
}

Vec3 plain(const ::tactum::Vec3& v) noexcept {
    return {v.x(), v.y(), v.z()};
}

bool canBe(const ::tactum::Vec3& finger, const ::tactum::Vec3& velocity, double dt) noexcept {
    return dt >= kShortest && dt <= kLongest && velocity.allFinite() &&
           velocity.cwiseAbs().maxCoeff() <= kFastest && finger.cwiseAbs().maxCoeff() <= kFarthestPlace &&
           finger.allFinite();
}

} // namespace

SteppedWorld::SteppedWorld(std::shared_ptr<const ::tactum::World> first)
    : kept_{std::move(first)}, world_(kept_.back().get()) {}

void SteppedWorld::takeOver() noexcept {
    if (!next_.load(std::memory_order_relaxed)) return;
    if (const ::tactum::World* next = next_.exchange(nullptr, std::memory_order_acquire)) {
        retired_.push(world_); // has room: each offer empties it, and brings one
        world_ = next;
    }
}

Step SteppedWorld::report(const HapticOutput& output) const noexcept {
    Step step;
    step.time = time_;
    step.proxy = plain(output.proxy);
    step.force = plain(output.force);
    step.contacts = std::uint32_t(std::min<std::size_t>(std::size_t(output.contacts), kMostContacts));
    for (std::size_t i = 0; i < step.contacts; ++i) {
        const ContactReport& from = output.contact[i];
        step.contact[i] = {.point = plain(from.point),
                           .normal = plain(from.normal),
                           .normalForce = from.normalForce,
                           .object = world_->bodies[from.body].object,
                           .surface = from.surface,
                           .slipping = from.slipping,
                           .frictionless = from.frictionless};
    }
    return step;
}

Step SteppedWorld::step(const Vec3& to, const Vec3* velocity, double dt) noexcept {
    takeOver();
    HapticInput input;
    input.finger = eigen(to);
    if (velocity)
        input.fingerVelocity = eigen(*velocity);
    else if (begun_)
        input.fingerVelocity = (input.finger - before_) / dt;
    Step step;
    if (!canBe(input.finger, input.fingerVelocity, dt)) {
        step.time = time_;
        step.proxy = plain(state_->proxy.position);
    } else {
        time_ += dt;
        step = report(hapticStep(*world_, *state_, input, dt));
        before_ = input.finger;
        begun_ = true;
    }
    step.finger = to;
    return step;
}

void SteppedWorld::restart(double time) noexcept {
    *state_ = {};
    state_->time = time_ = time;
    begun_ = false;
}

void SteppedWorld::offer(std::shared_ptr<const ::tactum::World> world) {
    kept_.push_back(std::move(world));
    const ::tactum::World* untaken = next_.exchange(kept_.back().get(), std::memory_order_acq_rel);
    if (untaken) release(untaken);
    for (const ::tactum::World* old = nullptr; retired_.pop(old);)
        release(old);
}

void SteppedWorld::release(const ::tactum::World* world) {
    std::erase_if(kept_, [&](const auto& one) { return one.get() == world; });
}

} // namespace tactum::library
