// The move stage (section 2.1): what ends a move, and what the proxy touches then. Thread: real time.
#include <array>
#include <utility>

#include "core/proxy/passed_bodies.h"
#include "core/proxy/step.h"

namespace tactum {

namespace {

// What a sweep looks ahead by, in radii. Each face that it looks for besides costs more than the round that
// it may spare, so where nothing but planes holds the proxy it looks near. Where rounds grow many, on rough
// ground, more is foreseen: without that three of 40,000 steps over rough height fields ran out of rounds.
// With friction a face that was not foreseen would hold the proxy before it is slid on.
constexpr double kLookNear = 1e-3, kLookFar = 1e-2;
constexpr int kNearSighted = 10;
// Past its edge by less than this part of the radius a face still counts as touched (kKeep).
constexpr double kSamePlace = 2e-3;

/// Of one surface that is felt as it is and that nothing sticks to. Of several nobody looks.
bool isPlain(const Obstacle& obstacle) noexcept {
    return obstacle.materials.size() == 1 && !hasFriction(obstacle.materials[0]) && obstacle.feels.empty();
}

} // namespace

// The move stage. Primitives with a plane are left out: a C-obstacle is convex, so the half-space above
// its plane is free of it.
SweepHit Step::sweep(const Vec3& motion, std::uint32_t& body) noexcept {
    SweepHit first;
    const auto look = [&](std::uint32_t i) { sweepOne(i, motion, first, body); };
    forEachNear(near_, obstacles_.size(), state_.position, radius_ + motion.norm(), look);
    return first;
}

bool Step::looksNear(const Obstacle& obstacle) const noexcept {
    return smooth_ && rounds_ <= kNearSighted && (pushing_ > 0 || isPlain(obstacle));
}

// Of two bodies that are met at the same time the one with the lower index counts, in whichever order they
// come.
void Step::sweepOne(std::uint32_t i, const Vec3& motion, SweepHit& first, std::uint32_t& body) noexcept {
    const Obstacle& obstacle = obstacles_[i];
    if (hasPassed(state_, i)) return;
    std::array<Index, kMaxPlanes> touched;
    std::size_t count = 0;
    for (const Contact& contact : contacts())
        if (contact.body == i) touched[count++] = contact.triangle;
    const Pose pose = poseNow(obstacle, movers_);
    const Vec3 from_B = pose.applyInverse(state_.position);
    const SpherePath path{
        from_B,         pose.rotateInverse(motion),  radius_ * (1 - kSkin),
        obstacle.sides, cameFrom(state_, i, from_B), looksNear(obstacle) ? kLookNear : kLookFar};
    // Of many bodies most are far away, and memories are few.
    if (obstacles_.size() > state_.memories.size() &&
        obstacle.mesh->tree.isBeyond(path.from, path.radius + path.motion.norm()))
        return;
    SweepMemory& memory = state_.memories[i % state_.memories.size()];
    const SweepHit hit = sweepFrom(memory, *obstacle.mesh, path, {touched.data(), count});
    if (hit.t < first.t || (hit.t == first.t && hit.t <= 1 && i < body)) {
        first = hit;
        body = i;
    } else if (hit.soonCount > 0 && body == kNoBody) {
        takeSoon(i, hit, path.from + path.motion, first);
    }
}

// Of several bodies the one whose face is the nearest to where the move ends, in whichever order they come.
void Step::takeSoon(std::uint32_t i, const SweepHit& hit, const Vec3& end_B, SweepHit& first) noexcept {
    const auto far = [&] {
        return (closestPoint(obstacles_[i].triangle(hit.soon[0]), end_B).point - end_B).norm();
    };
    const double gap = obstacles_.size() > 1 ? far() : 0;
    if (first.soonCount > 0 && (gap > soonGap_ || (gap == soonGap_ && i > soonBody_))) return;
    first.soon = hit.soon;
    first.soonCount = hit.soonCount;
    soonBody_ = i;
    soonGap_ = gap;
}

// All motion of the rounds, but the way back to the nearest place.
void Step::goTo(const Vec3& place) noexcept {
    const Vec3 before = std::exchange(state_.position, place);
    if (oneSided_) followMoved(state_, obstacles_, movers_, radius_, before, near_);
}

bool Step::isFeltFrom(const Contact& contact, const Vec3& place_W) noexcept {
    const Obstacle& obstacle = obstacles_[contact.body];
    return obstacle.sides.empty() ||
           isFelt(obstacle.sides[obstacle.surfaceOf(contact.triangle)], obstacle.triangle(contact.triangle),
                  poseNow(obstacle, movers_).applyInverse(place_W));
}

// A proxy that rolled around an edge to the side from which nothing is felt there goes on freely. Within a
// step it slides past that side for a moment, in the tangent plane, and drops back: where it ends the finger
// says.
bool Step::isStillFelt(const Contact& contact) noexcept {
    if (obstacles_[contact.body].sides.empty()) return true;
    const Pose pose = poseNow(obstacles_[contact.body], movers_);
    const Vec3 from_B = cameFrom(state_, contact.body, pose.applyInverse(state_.position));
    const bool slides = rounds_ > 0 && contact.gap >= -kKeep * kSkin * radius_;
    return isFeltFrom(contact, pose.apply(from_B)) || (slides && isFeltFrom(contact, finger_));
}

// Adds the primitive that ended a move. Without room for its plane the step ends here, outside.
bool Step::meet(std::uint32_t body, Index triangle) noexcept {
    if (state_.contactCount == kMaxPlanes) return false;
    Contact contact;
    contact.body = body;
    contact.triangle = triangle;
    contact.slipping = state_.slidingOn == body;
    locate(contact);
    state_.contacts[state_.contactCount++] = contact;
    return true;
}

// Faces that the proxy is about to touch hold it in the next round already, instead of costing one each.
// The half-space above any plane is free of its primitive; but an edge's plane would stop a slide toward
// a flat neighbour.
void Step::foresee(std::uint32_t body, const SweepHit& hit) noexcept {
    for (int i = 0; i < hit.soonCount; ++i) {
        if (!meet(body, hit.soon[std::size_t(i)])) return;
        const Contact& contact = state_.contacts[std::size_t(state_.contactCount - 1)];
        if (contact.bend > 0 || contact.gap > kHover * radius_)
            --state_.contactCount;
        else if (felt_)
            takeOver();
    }
}

// Where the proxy has slid onto the face that was met last, what it slid from touches it with an edge at the
// same place: the face alone is what it slides on from there, and it pushes as that did.
void Step::takeOver() noexcept {
    Contact face = state_.contacts[std::size_t(--state_.contactCount)];
    const auto others = contacts();
    const auto isLeft = [&](const Contact& c) {
        return c.body == face.body && c.bend > 0 && (c.point - face.point).norm() <= kSamePlace * radius_;
    };
    for (const Contact& contact : others)
        if (isLeft(contact)) handOver(contact, face);
    state_.contactCount = int(std::remove_if(others.begin(), others.end(), isLeft) - others.begin());
    state_.contacts[std::size_t(state_.contactCount++)] = face;
}

// A push is never without the material that it was made with, nor without the planes that it is felt by.
void Step::handOver(const Contact& from, Contact& to) noexcept {
    if (from.lambda > to.lambda) {
        to.lambda = from.lambda;
        to.material = from.material;
    }
    for (int i = 0; i < state_.feltCount; ++i)
        if (FeltPlane& plane = state_.felt[std::size_t(i)];
            plane.body == from.body && plane.triangle == from.triangle)
            plane.triangle = to.triangle;
}

void Step::locate(Contact& contact) noexcept {
    tactum::locate(contact, obstacles_, movers_, radius_, state_.position);
}

} // namespace tactum
