// Around edges and vertices, where the C-obstacle is curved: how far beyond the tangent planes. Thread: real
// time.
#include <array>
#include <cmath>
#include <limits>

#include "core/proxy/step.h"

namespace tactum {

namespace {

// The proxy goes around an edge by at most this cosine at once.
constexpr double kSteepest = 0.5;
// Up to this curvature times depth Newton's step is trusted; beyond it the proxy is about to roll off.
constexpr double kMaxBent = 0.7;
// Beyond that a first guess goes no farther along an edge than this part of the radius, unless the plain step
// does: with 0.4 sweeps were longer, and more of the guesses in vain.
constexpr double kFirstGuess = 0.1;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

} // namespace

// The same on curved constraints. Around an edge or a vertex the C-obstacle is a cylinder or a sphere,
// and going to the foot on its tangent plane again and again only halves the error.
Vec3 Step::alongCurvature(const Vec3& flat, double excess) noexcept {
    std::array<const Contact*, 2> held{};
    int pushing = 0;
    for (const Contact& contact : contacts()) {
        if (contact.lambda <= 0) continue;
        if (pushing == 2) return flat;
        held[std::size_t(pushing++)] = &contact;
    }
    // One guess at a time: from where it led the proxy comes down by plain steps.
    if (pushing == 0 || vainRounds_ > 0) return flat;
    if (pushing == 1 && !(held[0]->lambda * held[0]->bend * bentPart(*held[0], flat / excess) > 0))
        return flat;
    const Vec3 bent = pushing == 1 ? aroundAlone(*held[0], flat) : alongBoth(*held[0], *held[1], flat);
    return guessed(flat, bent, std::span(held).first(std::size_t(pushing)));
}

// What is to be known about a guess when it turns out to be in vain.
Vec3 Step::guessed(const Vec3& flat, const Vec3& bent, std::span<const Contact* const> held) noexcept {
    if (bent == flat || !isAllowed(bent)) return flat;
    guess_ = (bent - flat).norm();
    guessedFrom_.clear();
    for (const Contact* contact : held)
        guessedFrom_.push(*contact);
    return bent;
}

// Not below any plane; and not around to a side from which a finger is not felt that is.
bool Step::isAllowed(const Vec3& motion) noexcept {
    return std::ranges::all_of(contacts(), [&](const Contact& contact) {
        return contact.normal.dot(motion) >= -std::max(contact.gap, 0.0) - rest_ &&
               (!oneSided_ || isFeltFrom(contact, state_.position + motion) || !isFeltFrom(contact, finger_));
    });
}

// How much of a direction the C-obstacle bends in.
double Step::bentPart(const Contact& contact, const Vec3& way) noexcept {
    const double along = contact.edge.dot(way), out = contact.normal.dot(way);
    return std::max(0.0, 1 - along * along - out * out);
}

// On one edge or vertex alone the answer is known: on the ray from there to the finger. In the tangent
// plane the proxy goes to just above it, and drops onto it in the next round. A finger beyond the edge
// has no such answer: the proxy rolls off, around the edge. Along it the plain step knows how far.
Vec3 Step::aroundAlone(const Contact& contact, const Vec3& flat) noexcept {
    const Vec3 foot = contact.point + contact.edge * contact.edge.dot(finger_ - contact.point);
    const Vec3 out = finger_ - foot;
    const double rise = contact.normal.dot(out);
    if (rise > kSteepest * out.norm())
        return withinReach(flat, foot + out * (radius_ / rise) - state_.position);
    Vec3 across = flat - contact.normal * contact.normal.dot(flat);
    across -= contact.edge * contact.edge.dot(across);
    if (!(across.squaredNorm() > 0)) return flat;
    const Vec3 way = across.normalized();
    return farther(flat, way, contact.lambda * contact.bend * bentPart(contact, way));
}

// On two constraints one direction is left to go. The way down onto the planes is not to be stretched with
// it: it would lead below them.
Vec3 Step::alongBoth(const Contact& a, const Contact& b, const Vec3& flat) noexcept {
    const Vec3 axis = a.normal.cross(b.normal);
    const double length2 = axis.squaredNorm();
    if (!(length2 > 0)) return flat;
    const Vec3 way = axis / std::sqrt(length2);
    return farther(flat, way, a.lambda * a.bend * bentPart(a, way) + b.lambda * b.bend * bentPart(b, way));
}

// The curvature of all constraints together, the Hessian of the Lagrangian (4), 1 - sum lambda_i
// Hess(distance_i), of which `bend` is the sum, tells how far to go: Newton's method. It says little near the
// crest of what the proxy is about to roll over, and nothing beyond it, where plain rounds creep, the slower
// the nearer the finger is to the edge: there it goes as far as guesses have proved good.
Vec3 Step::farther(const Vec3& flat, const Vec3& way, double bend) noexcept {
    const double along = way.dot(flat), plain = std::abs(along);
    const double newton = bend < 1 ? plain / (1 - bend) : kInfinity;
    const double first = std::max(plain, kFirstGuess * radius_);
    const double wanted = bend < kMaxBent ? newton : std::min(newton, first);
    return withinReach(flat, flat + std::copysign(wanted - plain, along) * way);
}

// As far beyond the plain step as guesses may go now.
Vec3 Step::withinReach(const Vec3& flat, const Vec3& curved) const noexcept {
    const Vec3 beyond = curved - flat;
    const double length = beyond.norm();
    return length <= reach_ ? curved : Vec3(flat + beyond * (reach_ / length));
}

} // namespace tactum
