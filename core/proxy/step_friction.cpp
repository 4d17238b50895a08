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

// Sections 4.1 and 4.2: any plane in static contact holds; of the sliding ones the lowest bound wins.
double Step::frictionAllows(const Vec3& wish, double excess) noexcept {
    if (isHeld(excess)) return 0;
    const double speed = fingerVelocity_.dot(wish) / excess;
    double slide = excess;
    for (Contact& contact : contacts()) {
        if (contact.lambda <= 0) continue;
        contact.slipping = true;
        state_.slidingOn = contact.body;
        const FrictionLimit limit = frictionLimit(contact.material, true);
        slide = std::min(slide, allowedSlide(limit, excess, depthOn(contact), speed, timeLeft_));
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

bool Step::isHeld(double excess) noexcept {
    bool held = false;
    for (Contact& contact : contacts()) {
        const FrictionLimit limit = frictionLimit(contact.material, contact.slipping);
        if (contact.lambda > 0 && excess <= limit.coefficient * depthOn(contact)) held = true;
    }
    return held;
}

bool Step::isViscous() noexcept {
    return std::ranges::any_of(contacts(), [&](const Contact& contact) {
        return contact.lambda > 0 && contact.material.viscosity > 0;
    });
}

} // namespace tactum
