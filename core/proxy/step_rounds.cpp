// The rounds of a step, and the update stage on facets that feel as they are (section 2.2). Thread: real
// time.
#include <utility>

#include "core/proxy/step.h"

namespace tactum {

namespace {

// The speed that textures are filtered for falls by this factor a step at most: bumps slow the proxy down for
// a moment, which shall not let finer ones through.
constexpr double kSpeedDecay = 0.9;
constexpr double kSamePlane = 1e-12;
// So many rounds may pass until one is nearer than where a curved step began: its own, and those that come
// down from there.
constexpr int kMaxVain = 3;
// After one that did not lead nearer the next goes by this part of its length.
constexpr double kShorter = 0.25;

} // namespace

ProxyReport Step::run() noexcept {
    ProxyReport report;
    keepAsNearest((finger_ - state_.position).norm());
    countStillSteps();
    // Mostly a step begins where the last one ended.
    refreshContacts(state_.seenFrom == state_.position && movers_.empty());
    report.boundHit = true;
    for (rounds_ = 1; rounds_ <= mostRounds_; ++rounds_) {
        if (round())
            judge();
        else if (!isAstray()) {
            report.boundHit = false;
            break;
        }
    }
    if (report.boundHit) {
        returnToNearest();
        comeDown();
    }
    report.rounds = std::min(rounds_, mostRounds_);
    report.squeezed = squeezed_;
    finish();
    return report;
}

// Whether the round led nearer to the finger than any before. A curved step is a guess, judged together with
// the rounds that come down from where it led. While guesses lead nearer they may go farther; after one that
// did not the next goes less far, until it is the plain step, which always leads nearer. One that is too far
// would lead to the same place again until no round is left, and in each step anew.
void Step::judge() noexcept {
    const double distance = (finger_ - state_.position).norm();
    const bool isGuess = !felt_ && (guessed_ || vainRounds_ > 0);
    if (distance < nearestDistance_) {
        keepAsNearest(distance);
        if (isGuess) reach_ *= 2;
        vainRounds_ = 0;
        return;
    }
    if (!isGuess) return;
    ++vainRounds_;
    if (vainRounds_ > 1 && !isFarther(distance))
        shortenGuesses();
    else if (vainRounds_ == kMaxVain)
        takeBackGuess();
}

// By more than the skin, within which a place is as good as another.
bool Step::isFarther(double distance) const noexcept {
    return distance > nearestDistance_ + kKeep * kSkin * radius_;
}

// Whether the step came to rest where a guess had led it, farther away than it was: then it goes on from the
// nearest place. On surfaces that are felt from one side alone a guess may end on the other.
bool Step::isAstray() noexcept {
    if (felt_ || vainRounds_ == 0 || !isFarther((finger_ - state_.position).norm())) return false;
    takeBackGuess();
    return true;
}

void Step::shortenGuesses() noexcept {
    reach_ = kShorter * guess_;
    vainRounds_ = 0;
}

// What held the proxy where the guess began holds it there again, beside what it has met since: none has to
// be found anew.
void Step::takeBackGuess() noexcept {
    shortenGuesses();
    for (const Contact& before : guessedFrom_.all()) {
        const auto isSame = [&](const Contact& c) {
            return c.body == before.body && c.triangle == before.triangle;
        };
        if (state_.contactCount < kMaxPlanes && std::ranges::none_of(contacts(), isSame))
            state_.contacts[std::size_t(state_.contactCount++)] = before;
    }
    goBackToNearest();
}

void Step::returnToNearest() noexcept {
    if (!felt_ && nearestDistance_ < (finger_ - state_.position).norm()) goBackToNearest();
}

void Step::keepAsNearest(double distance) noexcept {
    nearestDistance_ = distance;
    nearest_ = state_.position;
    if (!oneSided_) return;
    nearestStraddled_.clear();
    for (int i = 0; i < state_.straddledCount; ++i)
        nearestStraddled_.push(state_.straddled[std::size_t(i)]);
}

// What it was half through there it is half through again, and came to from where it came then.
void Step::goBackToNearest() noexcept {
    state_.position = nearest_;
    if (oneSided_) {
        const auto kept = nearestStraddled_.all();
        state_.straddledCount =
            int(std::ranges::copy(kept, state_.straddled.begin()).out - state_.straddled.begin());
    }
    refreshContacts();
}

// The constraint planes of all contacts, seen from the proxy.
Step::Planes Step::planes() noexcept {
    Planes planes;
    for (const Contact& contact : contacts())
        planes.push({contact.normal, -contact.gap});
    return planes;
}

// Update (2.2), friction (4), move (2.1). False when the proxy has come to rest for this step.
bool Step::round() noexcept {
    guessed_ = smooth_ = false;
    comeOut();
    const Vec3 wish = unconstrainedByFriction();
    if (wish.norm() <= rest_) return false;
    // Friction holds the slide back, never the way down onto what is pressed.
    const bool rubbing = rubs();
    smooth_ = !felt_ && !rubbing;
    const Vec3 drop = felt_ ? seatOnFelt() : rubbing ? seat() : Vec3::Zero();
    const Vec3 along = wish - drop;
    const double excess = along.norm();
    // Nor does a step end beside what is pressed, in the middle of a long slide: its last round only goes
    // down.
    bool onlyDown = rubbing && excess > rest_ && rounds_ == mostRounds_;
    const double slide = excess > rest_ && !onlyDown ? frictionAllows(along / excess, excess) : 0;
    // Friction that lets go entirely is none; the last rounds take no risks.
    const bool bold = rounds_ < mostRounds_ - 2;
    const bool free = slide == excess && bold;
    const Vec3 allowed = excess > 0 ? towardTheCone(drop, along, slide / excess) : Vec3::Zero();
    Vec3 motion = felt_  ? alongFelt(drop, allowed, heldBack(along, allowed), bold)
                  : free ? alongCurvature(wish, wish.norm())
                         : Vec3(drop + allowed);
    if (motion.norm() <= rest_) return onlyDown;
    // A curved step is a guess: where it led onto a flat face it went too far, and the next round says
    // so.
    const bool settles =
        felt_ && free && passes_->comeToRest(feltContacts(), state_.position, motion, settled());
    guessed_ = felt_ ? !settles && motion.norm() > settled() : free && motion != wish;
    std::uint32_t body = kNoBody;
    SweepHit hit = sweep(motion, body);
    // By the cone of what it is pressed against, and has left, it would go too far: first down.
    const bool leaves = !felt_ && !free && slide > 0 && drop.norm() > rest_ && body != kNoBody;
    if (leaves && holdsOn(body, hit.triangle, state_.position + hit.t * motion)) {
        onlyDown = true;
        motion = drop;
        body = kNoBody;
        hit = sweep(motion, body);
    }
    const bool takesTime = slide < excess && !onlyDown && isViscous();
    const double part = std::min(hit.t, 1.0);
    goTo(state_.position + part * motion);
    if (part * motion.norm() > rest_) forgetInactive();
    const bool planesTurned = refreshContacts();
    if (body != kNoBody) {
        if (!onlyDown) timeLeft_ *= 1 - part;
        if (!meet(body, hit.triangle)) return false;
        foresee(body, hit);
        return true;
    }
    if (planesTurned && hit.soonCount > 0) {
        const int had = pushing_;
        const bool alone = state_.contactCount == 0;
        if (had > 1 || felt_) foresee(soonBody_, hit);
        if (alone && state_.contactCount == 0) meet(soonBody_, hit.soon[0]);
    }
    // Whatever is met from here on in this step has no time left to be slid on against viscosity.
    if (takesTime) timeLeft_ = 0;
    if (settles) return !passes_->settleAsLooked(state_, feltContacts());
    if (felt_) return guessed_ || state_.contactCount == 0;
    return planesTurned || guessed_ || onlyDown || (rubbing && hovers());
}

// A proxy that was squeezed leaves the surfaces as soon as there is room, by the shortest way: friction
// holds it where it is, not inside of what it touches.
void Step::comeOut() noexcept {
    const auto isInside = [this](const Contact& c) { return c.gap < -kKeep * kSkin * radius_; };
    if (std::ranges::none_of(contacts(), isInside)) return;
    const NearestPoint out = nearestPoint(Vec3::Zero(), planes().all());
    if (!out.feasible) return;
    moveTowardFirst(out.x);
    nearestDistance_ = std::numeric_limits<double>::infinity(); // where it was is no place to return to
}

// The last round of a step that needed more ended in the middle of a slide, beside what is felt or above it.
void Step::comeDown() noexcept {
    if (!felt_) return;
    const Vec3 down = state_.contactCount > 0 ? seatOnFelt() : Vec3(finger_ - state_.position);
    if (down.norm() > rest_) moveTowardFirst(down);
}

// As far as to what is met first.
void Step::moveTowardFirst(const Vec3& motion) noexcept {
    std::uint32_t body = kNoBody;
    const SweepHit hit = sweep(motion, body);
    goTo(state_.position + std::min(hit.t, 1.0) * motion);
    refreshContacts();
    if (body != kNoBody) meet(body, hit.triangle);
}

// The update stage: where the proxy would go if nothing but the planes held it, relative to it.
Vec3 Step::unconstrainedByFriction() noexcept {
    felt_ = isFelt(obstacles_, contacts());
    const NearestPoint nearest = felt_ ? updateFelt() : updatePlain();
    squeezed_ |= !nearest.feasible;
    pushing_ = nearest.active;
    return nearest.x;
}

// On facets that feel as they are.
NearestPoint Step::updatePlain() noexcept {
    Planes held = planes();
    const NearestPoint nearest = nearestReachable(finger_ - state_.position, held.all());
    for (int i = 0; i < state_.contactCount; ++i) {
        Contact& contact = state_.contacts[i];
        contact.lambda = nearest.lambda[i];
        if (contact.lambda > 0) contact.material = obstacles_[contact.body].material(contact.triangle);
    }
    state_.feltCount = 0;
    return nearest;
}

void Step::countStillSteps() noexcept {
    const bool still = finger_ == state_.finger && movers_.empty();
    if (!still) state_.stride = std::numeric_limits<double>::infinity();
    state_.stillFor = still ? std::min(state_.stillFor + 1, 1 << 20) : 0;
}

// Recomputes every plane, unless all are known for this place, and drops what is no longer touched; says
// whether any plane turned or went.
bool Step::refreshContacts(bool known) noexcept {
    state_.seenFrom = state_.position;
    bool changed = false;
    int kept = 0;
    for (Contact& contact : contacts()) {
        const Vec3 before = contact.normal;
        const bool wasBent = contact.bend > 0;
        if (!known) locate(contact);
        const bool turned = (contact.normal - before).squaredNorm() > kSamePlane * kSamePlane;
        // What still pushed and is only just left is come back to: rolling, or a move that was cut short.
        const double keep = contact.lambda > 0 && (wasBent || !turned) ? kHover : kKeep * kSkin;
        changed = changed || turned;
        if (contact.gap <= keep * radius_ && isStillFelt(contact)) {
            if (Contact& place = state_.contacts[std::size_t(kept++)]; &place != &contact) place = contact;
        } else {
            changed = true;
        }
    }
    state_.contactCount = kept;
    return changed;
}

// After a real move, planes that did not push are found again by the sweep if they matter.
void Step::forgetInactive() noexcept {
    const auto all = contacts();
    const auto idle = [](const Contact& c) { return c.lambda <= 0; };
    state_.contactCount = int(std::remove_if(all.begin(), all.end(), idle) - all.begin());
}

void Step::finish() noexcept {
    const double moved = (state_.position - start_).norm();
    state_.speed = std::max(moved / dt_, kSpeedDecay * state_.speed);
    const bool stuck = moved <= rest_ && sticksAtRest();
    for (Contact& contact : contacts())
        if (stuck) contact.slipping = false;
    if (stuck || state_.contactCount == 0) state_.slidingOn = kNoBody;
    state_.finger = finger_;
}

} // namespace tactum
