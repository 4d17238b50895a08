// On surfaces that feel otherwise than their facets: down, along, and to rest. Thread: real time.
#include "core/proxy/step.h"
#include "core/surface/friction.h"

namespace tactum {

namespace {

// Under a finger that moves, the rounds on a felt surface end with a motion below this part of the radius.
constexpr double kSettled = 1e-4;
// A stride on a felt surface that need not turn back may be so much longer next time.
constexpr double kStrideGrowth = 1.2;
// A push is made so many times harder at most to lead down onto its plane.
constexpr double kMaxPush = 1e3;
// A way down that leads less far than this part of it is blocked.
constexpr double kBlocked = 0.5;
// A finger that holds still for so many steps feels the proxy come to rest, each step with half the stride.
constexpr int kSettling = 8;
// Where a viscous slide has to die out first, so many of its lags later, but no more steps than that.
constexpr double kLags = 20, kMaxLag = 1e5;

} // namespace

// Features that pass by too fast for the steps are left out, and those that the ball would bridge: of a
// picture with finer texels than that each would be felt by the rounding of its 16 bits. A finger at rest
// feels all others, however far the proxy just went: what is felt must not change while the proxy settles.
FeltContacts Step::feltContacts() noexcept {
    const double finger = fingerVelocity_.norm(), speed = std::min(state_.speed, finger),
                 feature = kStepsToAFeature * speed * dt_;
    return {obstacles_,
            movers_,
            contacts(),
            radius_,
            finger_,
            std::max(feature, kFinestFeature * radius_),
            finger > 0 ? Vec3(feature / finger * fingerVelocity_) : Vec3::Zero()};
}

// On facets that feel otherwise.
NearestPoint Step::updateFelt() noexcept {
    if (!passes_) passes_.emplace();
    return passes_->update(state_, feltContacts());
}

// Down onto the surfaces, and along them as far as the felt normal, which changes on the way, still leads
// on. Between where the drop and where the wish end no plane is crossed.
Vec3 Step::alongFelt(const Vec3& drop, Vec3 slide, double back, bool mayExtend) noexcept {
    if (slide.norm() <= rest_) return drop;
    // The last round's slide is too short for the felt normal to change on it.
    const bool isLast = slide.norm() <= settled();
    const FeltPasses::Hold hold{back, lag(), followedPart(lag(), timeLeft_)};
    const double reach =
        isLast ? 1 : passes_->reach(state_, feltContacts(), drop, slide, hold, settled(), mayExtend);
    if (reach <= 1 || isAllowed(drop + reach * slide)) slide *= reach;
    // What is left over of a slide says nothing of how far to turn back.
    if (slide.dot(lastSlide_) < 0 && lastSlide_.norm() > settled()) state_.stride = 0.5 * lastSlide_.norm();
    const double most = std::min(state_.stride, settlingStride());
    if (const double length = slide.norm(); length > most) slide *= most / length;
    state_.stride *= kStrideGrowth;
    lastSlide_ = slide;
    return drop + slide;
}

double Step::settled() const noexcept {
    return state_.stillFor > 0 ? rest_ : kSettled * radius_;
}

// Where the proxy, which went ahead on tangents, is pressed down to: no friction and no felt normal has a
// say in it.
Vec3 Step::seat() noexcept {
    if (isSeated()) return Vec3::Zero();
    Vec3 push = Vec3::Zero();
    double scale = 1; // what pushes hardly still goes all the way down
    for (const Contact& contact : contacts()) {
        push -= contact.lambda * contact.normal;
        if (contact.lambda > 0) scale = std::max(scale, contact.gap / contact.lambda);
    }
    Planes held = planes();
    return nearestReachable(std::min(scale, kMaxPush) * push, held.all()).x;
}

// Once down it stays: where planes hardly lean from each other the way onto all of them at once is mostly
// rounding, and what is just touched without a push would be left, met and left again.
bool Step::isSeated() noexcept {
    return std::ranges::none_of(contacts(), [this](const Contact& contact) {
        return contact.lambda > 0 && std::abs(contact.gap) > rest_;
    });
}

// Other planes, which the slide left behind, may have held it above what it is pressed against.
bool Step::hovers() noexcept {
    return std::ranges::any_of(contacts(), [this](const Contact& contact) {
        return contact.lambda > 0 && contact.gap > kKeep * kSkin * radius_;
    });
}

// The same where something is felt otherwise: down onto the nearest of what pushes. What else pushes lies
// ahead, in a fold perhaps, and its multiplier is that of a slide that gets there; only friction may allow
// that. So it may where something else that is touched is in the way.
Vec3 Step::seatOnFelt() noexcept {
    const Contact* nearest = nullptr;
    for (const Contact& contact : contacts())
        if (contact.lambda > 0 && (!nearest || contact.gap < nearest->gap)) nearest = &contact;
    if (!nearest || nearest->gap <= rest_) return Vec3::Zero();
    Planes held = planes();
    const Vec3 drop = nearestReachable(-nearest->gap * nearest->normal, held.all()).x;
    return -drop.dot(nearest->normal) < kBlocked * nearest->gap ? Vec3::Zero() : drop;
}

// Normals can be such that a felt surface nowhere holds the finger: it shall not move under a hand that
// does not.
double Step::settlingStride() const noexcept {
    const int late = state_.stillFor - kSettling - int(std::min(kLags * lag() / dt_, kMaxLag));
    return late < 0 ? std::numeric_limits<double>::infinity() : std::ldexp(radius_, -late);
}

} // namespace tactum
