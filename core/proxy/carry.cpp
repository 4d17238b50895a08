#include "core/proxy/carry.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/proxy/carry_bounds.h"
#include "core/proxy/near_bodies.h"
#include "core/proxy/passed_bodies.h"
#include "core/proxy/straddled_bodies.h"
#include "core/surface/friction.h"

namespace tactum {

namespace {

// A piece of a relative path leaves its chord by at most this part of the radius.
constexpr double kSagitta = 1e-3;
// Contacts that the proxy left by more than this part of the radius on the way are forgotten.
constexpr double kLeft = 0.1;
// The speed at which a viscous contact is compared with a dry one, m/s: that of a hand.
constexpr double kHandSpeed = 0.1;
// The way back from under a body that passed over the proxy is free for this part of it.
constexpr double kWayBack = 0.5 * (1 - kMaxGive);

/// The first contact on the way.
struct Meeting {
    SweepHit hit;
    std::uint32_t body = kNoBody;
    Vec3 at_B = Vec3::Zero(); ///< the proxy then
};

class Carry {
public:
    Carry(ProxyState& state, std::span<const Obstacle> obstacles, const StepMotions& movers, double radius,
          const NearBodies* near)
        : state_(state), obstacles_(obstacles), movers_(movers), radius_(radius), near_(near) {}

    CarryReport run() noexcept {
        letGoOfJumps();
        const Contact* hold = strongestHold();
        ride_ = motionUnder(hold);
        report_.start = state_.position;
        // Where nothing rubs it is still seen from the body how fast a texture passes.
        if (const auto seenFrom = hold ? ride_ : motionUnder(strongestPush())) {
            report_.start = seenFrom->carried(state_.position);
            state_.finger = seenFrom->carried(state_.finger);
        }
        const int pieces = look();
        if (pieces == 0) followSides(state_.position);
        for (int i = 0; i < pieces; ++i)
            goTogether(double(i) / pieces, double(i + 1) / pieces);
        followPassed(state_, obstacles_, movers_, kWayBack * radius_);
        return report_;
    }

private:
    std::span<Contact> contacts() { return {state_.contacts.data(), std::size_t(state_.contactCount)}; }
    std::span<PassedBody> passed() { return {state_.passed.data(), std::size_t(state_.passedCount)}; }

    bool moves(std::uint32_t body) const noexcept {
        if (obstacles_[body].mover < 0 || jumps(body)) return false;
        const BodyMotion motion = movers_.of(obstacles_[body].mover);
        return !(motion.before == motion.now);
    }

    // What jumps farther than the proxy is wide is put there; a lesser jump is swept like a motion.
    bool jumps(std::uint32_t body) const noexcept {
        if (obstacles_[body].mover < 0) return false;
        const BodyMotion motion = movers_.of(obstacles_[body].mover);
        return motion.jumped && (motion.carried(from_W_) - from_W_).norm() > 2 * radius_;
    }

    Pose poseAt(std::uint32_t body, double part) const noexcept {
        const Obstacle& obstacle = obstacles_[body];
        if (obstacle.mover < 0) return obstacle.pose;
        const BodyMotion motion = movers_.of(obstacle.mover);
        return moves(body) ? motion.between(part) : motion.now;
    }

    template <class Unwanted> void forget(Unwanted&& unwanted) noexcept {
        const auto all = contacts();
        state_.contactCount = int(std::remove_if(all.begin(), all.end(), unwanted) - all.begin());
    }

    void letGoOfJumps() noexcept {
        forget([this](const Contact& contact) { return jumps(contact.body); });
        const auto all = passed();
        const auto gone = [this](const PassedBody& p) { return jumps(p.body); };
        state_.passedCount = int(std::remove_if(all.begin(), all.end(), gone) - all.begin());
    }

    // Of all contacts that push, the one that could bear most tangential force.
    const Contact* strongestHold() noexcept {
        const Contact* best = nullptr;
        double most = 0;
        for (const Contact& contact : contacts()) {
            const FrictionLimit limit = frictionLimit(contact.material, contact.slipping);
            const double hold =
                contact.lambda > 0 ? limit.coefficient * contact.lambda + limit.lag * kHandSpeed : 0;
            if (hold > most) most = hold, best = &contact;
        }
        return best;
    }

    // What the proxy is pressed against the most.
    const Contact* strongestPush() noexcept {
        const Contact* best = nullptr;
        for (const Contact& contact : contacts())
            if (contact.lambda > (best ? best->lambda : 0)) best = &contact;
        return best;
    }

    // On a body at rest: none.
    std::optional<BodyMotion> motionUnder(const Contact* contact) const noexcept {
        if (!contact || !moves(contact->body)) return std::nullopt;
        return movers_.of(obstacles_[contact->body].mover);
    }

    // Which bodies can reach the proxy, and into how many pieces that cuts the step.
    int look() noexcept {
        double pieces = 0;
        const double reach = radius_ + (report_.start - state_.position).norm();
        forEachNear(near_, obstacles_.size(), state_.position, reach, [&](std::uint32_t body) {
            if (!moves(body) || !canReach(body)) return;
            const BodyMotion motion = movers_.of(obstacles_[body].mover);
            const double turn = motion.before.rotation.angularDistance(motion.now.rotation);
            const double slide = (motion.now.translation - motion.before.translation).norm();
            const Vec3 at_B = motion.before.applyInverse(state_.position);
            // The second derivative of the relative path is at most this; a chord's sagitta is an eighth of
            // it.
            const double bend = turn * turn * at_B.norm() + 2 * turn * slide;
            pieces =
                std::max({pieces, 1.0, (motion.carried(state_.position) - state_.position).norm() / radius_,
                          std::sqrt(bend / (8 * kSagitta * radius_))});
        });
        return int(std::ceil(std::min(pieces, double(kMaxPieces))));
    }

    // Whether a moving body can come to the proxy in this step.
    bool canReach(std::uint32_t body) const noexcept {
        if (ride_) return true;
        const BodyMotion motion = movers_.of(obstacles_[body].mover);
        const double turn = motion.before.rotation.angularDistance(motion.now.rotation);
        const double slide = (motion.now.translation - motion.before.translation).norm();
        const Vec3 at_B = motion.before.applyInverse(from_W_);
        return !obstacles_[body].mesh->tree.isBeyond(at_B, radius_ + slide + turn * at_B.norm());
    }

    void goTogether(double from, double to) noexcept {
        from_ = from, to_ = to;
        const Vec3 before_W = state_.position;
        makeRoom(before_W);
        followSides(before_W);
    }

    void followSides(const Vec3& before_W) noexcept {
        if (near_ ? near_->oneSided() : anyOneSided(obstacles_))
            followCarried(state_, obstacles_, movers_, radius_, before_W, from_, to_, near_);
    }

    // One piece of the step: a goal, and rounds of sweeping to it and keeping out of what was met.
    void makeRoom(const Vec3& start) noexcept {
        startBounds();
        for (int met = 0; true;) {
            const auto place = bounds_.nearestTo(rideFrom(start), radius_);
            const Meeting meeting = place ? firstOnTheWay(start, *place) : Meeting{};
            report_.sweeps = std::max(report_.sweeps, met + 1);
            if (place && meeting.body == kNoBody) return settle(*place);
            if (place && met < kMaxCarryRounds && !bounds_.full()) {
                bound(meeting.body, meeting.hit.triangle, meeting.at_B);
                ++met;
                continue;
            }
            if (!passOver(meeting.body)) return;
            startBounds();
            met = 0;
        }
    }

    void settle(const CarryBounds::Place& place) noexcept {
        state_.position = place.at;
        report_.squeezed |= place.give > 0;
        keepBounds();
    }

    Vec3 rideFrom(const Vec3& start) const noexcept {
        if (!ride_) return start;
        return ride_->between(to_).apply(ride_->between(from_).applyInverse(start));
    }

    void startBounds() noexcept {
        bounds_.clear();
        for (const Contact& contact : contacts()) {
            const Vec3 at_B = poseAt(contact.body, from_).applyInverse(state_.position);
            bound(contact.body, contact.triangle, at_B);
        }
    }

    // A C-obstacle is convex: the half-space that touches it where the proxy met it is free of it, on the
    // whole way from the proxy's start.
    void bound(std::uint32_t body, Index triangle, const Vec3& at_B) noexcept {
        const Vec3 point = closestPoint(obstacles_[body].triangle(triangle), at_B).point;
        const Vec3 away = at_B - point;
        const double distance = away.norm();
        if (!(distance > 0)) return;
        const Pose pose = poseAt(body, to_);
        const Vec3 normal = pose.rotate(away / distance);
        bounds_.add({body, triangle, {normal, normal.dot(pose.apply(point)) + radius_}});
    }

    Meeting firstOnTheWay(const Vec3& start, const CarryBounds::Place& place) noexcept {
        Meeting first;
        const bool stays = start == place.at;
        const double reach = radius_ + (place.at - start).norm();
        forEachNear(near_, obstacles_.size(), start, reach, [&](std::uint32_t body) {
            if (stays && !(moves(body) && canReach(body))) return;
            if (hasPassed(state_, body)) return;
            const Vec3 from_B = poseAt(body, from_).applyInverse(start);
            const Vec3 way_B = poseAt(body, to_).applyInverse(place.at) - from_B;
            const SpherePath path{from_B, way_B, (radius_ - place.give) * (1 - kSkin), obstacles_[body].sides,
                                  cameFrom(state_, body, from_B)};
            const SweepHit hit = sweepBody(body, path);
            if (hit.t < first.hit.t || (hit.t == first.hit.t && hit.t <= 1 && body < first.body))
                first = {hit, body, from_B + hit.t * way_B};
        });
        return first;
    }

    SweepHit sweepBody(std::uint32_t body, const SpherePath& path) noexcept {
        std::array<Index, kMaxPlanes> bounding;
        std::size_t count = 0;
        for (const Bound& bound : bounds_.all())
            if (bound.body == body) bounding[count++] = bound.triangle;
        SweepMemory& memory = state_.memories[body % state_.memories.size()];
        return sweepFrom(memory, *obstacles_[body].mesh, path, {bounding.data(), count});
    }

    // What bounded the proxy is a contact from now on; what it left is none any more.
    void keepBounds() noexcept {
        for (const Bound& met : bounds_.all()) {
            const bool known = std::ranges::any_of(contacts(), [&met](const Contact& contact) {
                return contact.body == met.body && contact.triangle == met.triangle;
            });
            if (known || state_.contactCount == kMaxPlanes) continue;
            Contact contact;
            contact.body = met.body;
            contact.triangle = met.triangle;
            contact.slipping = state_.slidingOn == met.body;
            state_.contacts[state_.contactCount++] = contact;
        }
        forget([this](const Contact& contact) {
            const Vec3 at_B = poseAt(contact.body, to_).applyInverse(state_.position);
            const Vec3 point = closestPoint(obstacles_[contact.body].triangle(contact.triangle), at_B).point;
            return (at_B - point).norm() > (1 + kLeft) * radius_;
        });
    }

    // There is no place for the proxy: the moving body that it met last, or was just about to, goes on
    // without it. Bodies at rest are never passed. False when nothing moves that could.
    bool passOver(std::uint32_t body) noexcept {
        for (std::size_t i = bounds_.all().size(); i-- > 0 && (body == kNoBody || !moves(body));)
            body = bounds_.all()[i].body;
        if (body == kNoBody || !moves(body)) return giveUpTheRide();
        report_.passed = true;
        forget([body](const Contact& contact) { return contact.body == body; });
        if (state_.passedCount < kMaxPassed)
            state_.passed[state_.passedCount++] = {body, poseAt(body, from_).applyInverse(state_.position)};
        return true;
    }

    bool giveUpTheRide() noexcept { return std::exchange(ride_, std::nullopt).has_value(); }

    ProxyState& state_;
    std::span<const Obstacle> obstacles_;
    const StepMotions& movers_;
    double radius_;
    const NearBodies* near_;
    CarryReport report_;
    Vec3 from_W_ = state_.position;  ///< where the proxy was
    std::optional<BodyMotion> ride_; ///< of the body that holds the proxy by friction
    double from_ = 0, to_ = 1;       ///< the present piece of the step
    CarryBounds bounds_;
};

} // namespace

CarryReport carry(ProxyState& state, std::span<const Obstacle> obstacles, const StepMotions& movers,
                  double radius, const NearBodies* near) noexcept {
    if (movers.empty()) return {.start = state.position};
    return Carry(state, obstacles, movers, radius, near).run();
}

} // namespace tactum
