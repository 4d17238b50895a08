// Around edges and vertices, where the C-obstacle is curved: how far beyond the tangent planes. Thread: real
// time.
#include <array>
#include <utility>

#include "core/proxy/step.h"

namespace tactum {

namespace {

// The proxy goes around an edge by at most this cosine at once.
constexpr double kSteepest = 0.5;
// Up to this curvature times depth Newton's step is trusted; beyond it the proxy is about to roll off.
constexpr double kMaxBent = 0.7;
// A guess goes no farther along an edge than this part of the radius, unless the plain step does.
constexpr double kFarthestGuess = 0.4;

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
    if (pushing == 0) return flat;
    if (pushing == 1 && !(held[0]->lambda * held[0]->bend * bentPart(*held[0], flat / excess) > 0))
        return flat;
    const Vec3 bent = pushing == 1 ? aroundAlone(*held[0], flat) : alongBoth(*held[0], *held[1], flat);
    return isAllowed(bent) ? bent : flat;
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
// has no such answer: the proxy rolls off.
Vec3 Step::aroundAlone(const Contact& contact, const Vec3& flat) noexcept {
    const Vec3 foot = contact.point + contact.edge * contact.edge.dot(finger_ - contact.point);
    const Vec3 out = finger_ - foot;
    const double rise = contact.normal.dot(out);
    if (rise > kSteepest * out.norm()) return foot + out * (radius_ / rise) - state_.position;
    const Vec3 across = flat - contact.normal * contact.normal.dot(flat);
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
// crest of what the proxy is about to roll over, where plain rounds creep: there every other round is a bold
// one. What it gained shows in the next, when the proxy has dropped back onto the edge.
Vec3 Step::farther(const Vec3& flat, const Vec3& way, double bend) noexcept {
    const double newton = bend < 1 ? 1 / (1 - bend) : kBoldest;
    const bool trusted = bend < kMaxBent;
    const double most = trusted ? newton : std::exchange(wasBold_, !wasBold_) ? kRollFaster : boldness_;
    const double along = way.dot(flat), wanted = std::min(newton, most) * along;
    const double farthest = std::max(std::abs(along), kFarthestGuess * radius_);
    return flat + ((trusted ? wanted : std::clamp(wanted, -farthest, farthest)) - along) * way;
}

} // namespace tactum
