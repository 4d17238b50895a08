// Friction as a bound on the slide (section 4). Thread: real time.
#include "core/proxy/step.h"
#include "core/surface/friction.h"

namespace tactum {

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
    if (isHeld(way, excess)) return 0;
    const double speed = fingerVelocity_.dot(way);
    double slide = excess;
    for (Contact& contact : contacts()) {
        if (contact.lambda <= 0) continue;
        contact.slipping = true;
        state_.slidingOn = contact.body;
        const FrictionLimit limit = frictionLimit(contact.material, true);
        const double depth = depthOnSlope(contact, limit.coefficient, way);
        slide = std::min(slide, allowedSlide(limit, excess, depth, speed, timeLeft_));
    }
    return slide;
}

// Normal force on a contact divided by the stiffness.
double Step::depthOn(const Contact& contact) noexcept {
    double depth = 0;
    for (const Contact& other : contacts())
        depth += depthShare(other.lambda, other.normal, contact.normal);
    return depth;
}

// The same where the felt normal leans.
double Step::depthOnSlope(const Contact& contact, double coefficient, const Vec3& way) noexcept {
    const double depth = depthOn(contact);
    const FeltPlane* felt = feltAlone(contact);
    if (!felt) return depth;
    return depth * slopeFactor(felt->normal.dot(contact.normal), felt->normal.dot(way), coefficient);
}

// The felt plane of a contact, if it has one alone.
const FeltPlane* Step::feltAlone(const Contact& contact) noexcept {
    const FeltPlane* found = nullptr;
    for (int i = 0; i < state_.feltCount; ++i) {
        const FeltPlane& plane = state_.felt[std::size_t(i)];
        if (plane.body != contact.body || plane.triangle != contact.triangle) continue;
        if (found) return nullptr;
        found = &plane;
    }
    return found;
}

bool Step::isHeld(const Vec3& way, double excess) noexcept {
    bool held = false;
    for (Contact& contact : contacts()) {
        const FrictionLimit limit = frictionLimit(contact.material, contact.slipping);
        if (contact.lambda <= 0) continue;
        held |= excess <= limit.coefficient * depthOnSlope(contact, limit.coefficient, way);
    }
    return held;
}

bool Step::isViscous() noexcept {
    return std::ranges::any_of(contacts(), [&](const Contact& contact) {
        return contact.lambda > 0 && contact.material.viscosity > 0;
    });
}

} // namespace tactum
