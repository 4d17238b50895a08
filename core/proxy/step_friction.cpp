// Friction as a bound on the slide (section 4). Thread: real time.
#include "core/proxy/step.h"
#include "core/surface/friction.h"

namespace tactum {

namespace {

// On the edge of the dynamic cone the proxy still slips, though it waits: for a finger whose places come in
// steps of an encoder, or before a crease. Inside of it by so much the finger has come back.
constexpr double kWellInside = 0.8;
// On the edge it sticks when the speed of its last move, m/s, has decayed to this: after 50 steps from a fast
// stroke, 30 from a slow one.
constexpr double kSticksBelow = 5e-4;
// A felt slope whose square is below the square of this leads friction aside by less than a double tells.
constexpr double kLevel = 1e-6;

} // namespace

// Against viscosity coming to rest takes its time.
double Step::lag() const noexcept {
    double most = 0;
    for (const Contact& contact : contacts())
        if (contact.lambda > 0) most = std::max(most, frictionLimit(contact.material, true).lag);
    return most;
}

bool Step::rubs() noexcept {
    return std::ranges::any_of(contacts(), [](const Contact& contact) {
        return contact.lambda > 0 && hasFriction(contact.material);
    });
}

// Sections 4.1 and 4.2: any plane in static contact holds; of the sliding ones the lowest bound wins.
double Step::frictionAllows(const Vec3& way, double excess) noexcept {
    const Pushes pushing = pushes();
    if (isHeld(pushing, way, excess)) return 0;
    const double speed = fingerVelocity_.dot(way);
    double slide = excess;
    for (std::size_t i = 0; i < contacts().size(); ++i) {
        Contact& contact = contacts()[i];
        if (contact.lambda <= 0) continue;
        contact.slipping = true;
        state_.slidingOn = contact.body;
        if (pushing.size() == 0) continue; // nothing rubs
        const FrictionLimit limit = frictionLimit(contact.material, true);
        const double depth = depthOnSlope(pushing.all(), i, limit.coefficient, way);
        slide = std::min(slide, allowedSlide(limit, excess, depth, speed, timeLeft_));
    }
    return slide;
}

bool Step::isHeld(const Pushes& pushing, const Vec3& way, double excess) noexcept {
    bool held = false;
    onTheEdge_ = true;
    for (std::size_t i = 0; i < pushing.size(); ++i) {
        const Contact& contact = contacts()[i];
        if (contact.lambda <= 0) continue;
        const FrictionLimit limit = frictionLimit(contact.material, contact.slipping);
        const double bound = limit.coefficient * depthOnSlope(pushing.all(), i, limit.coefficient, way);
        held |= excess <= bound;
        if (excess <= kWellInside * bound) onTheEdge_ = false;
    }
    return held;
}

// Whether friction of what is met would hold the proxy there, by itself.
bool Step::holdsOn(std::uint32_t body, Index triangle, const Vec3& place) noexcept {
    Contact contact;
    contact.body = body;
    contact.triangle = triangle;
    tactum::locate(contact, obstacles_, movers_, radius_, place);
    const Vec3 wish = finger_ - place;
    const double depth = -wish.dot(contact.normal);
    const double coefficient = frictionLimit(obstacles_[body].material(triangle), true).coefficient;
    return (wish + depth * contact.normal).norm() < coefficient * depth;
}

// How far the proxy goes, after `drop`, of a wish of which friction allows a part. Friction stands against
// the way on the felt slope; the wish, which ends where the felt normal leads onto the true plane, reaches
// too far up and down that slope, by the square of its sine s. While the proxy goes on what is left of the
// wish shrinks by the power 1 - s^2 of what it shrinks by across the slope. Beside the wish other planes may
// be in the way.
Vec3 Step::towardTheCone(const Vec3& drop, const Vec3& along, double part) noexcept {
    const Vec3 straight = part * along, lean = part > 0 && part < 1 ? leanOfTheFelt() : Vec3::Zero();
    const double steep2 = lean.squaredNorm();
    if (!(steep2 > kLevel * kLevel)) return straight;
    const Vec3 uphill = along.dot(lean) / steep2 * lean;
    const double power = 1 - steep2 * uphill.squaredNorm() / along.squaredNorm();
    const double across = std::pow(1 - part, 1 / power), steep = std::pow(1 - part, (1 - steep2) / power);
    const Vec3 aside = (1 - across) * along - (steep - across) * uphill;
    return isAllowed(drop + aside) ? aside : straight;
}

// What of the wish along this slide is held back of it, m.
double Step::heldBack(const Vec3& along, const Vec3& slide) noexcept {
    const double length = slide.norm();
    return length > 0 ? std::max(0.0, along.dot(slide) / length - length) : 0;
}

// By how much the felt normal of what pushes leans from the true one, if both are one alone: across that.
Vec3 Step::leanOfTheFelt() noexcept {
    if (state_.feltCount != 1) return Vec3::Zero();
    const FeltPlane& plane = state_.felt[0];
    for (const Contact& contact : contacts())
        if (contact.body == plane.body && contact.triangle == plane.triangle)
            return plane.normal - plane.normal.dot(contact.normal) * contact.normal;
    return Vec3::Zero();
}

// Of what did not move in this step: whether the finger has come back into the cone, or the motion has died
// out.
bool Step::sticksAtRest() const noexcept {
    return !onTheEdge_ || state_.speed <= kSticksBelow;
}

// All contacts, in their order; none where nothing rubs.
Step::Pushes Step::pushes() noexcept {
    Pushes all;
    if (!rubs()) return all;
    for (const Contact& contact : contacts())
        all.push({contact.normal, contact.lambda, feltAlone(contact)});
    return all;
}

// The felt normal of a contact, if it has one alone.
std::optional<Vec3> Step::feltAlone(const Contact& contact) noexcept {
    std::optional<Vec3> found;
    for (int i = 0; i < state_.feltCount; ++i) {
        const FeltPlane& plane = state_.felt[std::size_t(i)];
        if (plane.body != contact.body || plane.triangle != contact.triangle) continue;
        if (found) return std::nullopt;
        found = plane.normal;
    }
    return found;
}

bool Step::isViscous() noexcept {
    return std::ranges::any_of(contacts(), [&](const Contact& contact) {
        return contact.lambda > 0 && contact.material.viscosity > 0;
    });
}

} // namespace tactum
