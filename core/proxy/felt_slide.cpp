// How far a slide leads over a surface whose felt normal, depth and friction change on the way. Thread: real
// time.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/proxy/felt_planes.h"
#include "core/surface/friction.h"

namespace tactum {

namespace {

// A slide is followed at most so many times as far as it was wished.
constexpr double kFarthest = 2;
// It is good if its end wishes no more than this part of it back.
constexpr double kOvershoot = 0.001;
constexpr int kSearches = 8;
// Of a wish that is gone without another look this part is left even where a secant tells how it changes; and
// of what it wishes aside of the way, where none does, this.
constexpr double kLeftOver = 0.02, kLeftOverAside = 0.4;
// So many looks are worth a round; each has to wish less than this part of what the last one did.
constexpr int kLooksOn = 4;
constexpr double kNearer = 0.7;
// Farther aside, by this part of the way there, other faces are likelier to be in the way.
constexpr double kFarthestAside = 0.3;
// Two secants tell of both directions where the square of the sine between them is above this, and of no root
// farther away than so many times the wish.
constexpr double kSameWay = 1e-4, kFarthestRoot = 4;

// A place on the way of a slide, and what is wished there along it, m.
struct Ahead {
    double part;
    double wish;
};

// Between one that leads on and one that leads back: where the wish turns, or is shorter than `near`. The
// Illinois method, and hardly beyond the turning point: where the felt normal jumps, on the edge between two
// painted triangles, the proxy comes to rest on the side that it came from.
double turningPoint(Ahead on, Ahead back, double near, const auto& wishAfter) noexcept {
    for (int i = 0; i < kSearches; ++i) {
        const double middle = on.part + (back.part - on.part) * on.wish / (on.wish - back.wish);
        const double wish = wishAfter(middle);
        if (std::abs(wish) <= near) return middle;
        if (wish > 0) {
            on = {middle, wish};
            back.wish *= 0.5;
        } else {
            back = {middle, wish};
            on.wish *= 0.5;
        }
    }
    return on.part;
}

// Around an edge a way that leads on leads down as well, beside the straight one: the next round goes there.
bool isAbove(std::span<const Contact> contacts, const Vec3& motion, double tolerance) noexcept {
    return std::ranges::all_of(contacts, [&](const Contact& contact) {
        return contact.normal.dot(motion) >= -contact.gap - tolerance;
    });
}

} // namespace

// What dry friction holds back of a wish along the unit vector `way` where the proxy slides: the least of
// the planes that push, m.
double FeltPasses::held(const Vec3& way) const noexcept {
    InplaceVector<Push, kMaxPlanes> pushes;
    for (std::size_t i = 0; i < on_->contacts.size(); ++i)
        pushes.push({true_[i].normal, result_.lambda[i], feltAlone(i)});
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < pushes.size(); ++i) {
        if (!(pushes[i].lambda > 0)) continue;
        const double coefficient = frictionLimit(material_[i], true).coefficient;
        // What lies ahead may lean from what the way goes along.
        const Vec3 along = (way - way.dot(true_[i].normal) * true_[i].normal).normalized();
        least = std::min(least, coefficient * depthOnSlope(pushes.all(), i, coefficient, along));
    }
    return std::isfinite(least) ? least : 0;
}

// Of the viscosity of what pushes, s.
double FeltPasses::lag() const noexcept {
    double most = 0;
    for (std::size_t i = 0; i < on_->contacts.size(); ++i)
        if (result_.lambda[i] > 0) most = std::max(most, frictionLimit(material_[i], true).lag);
    return most;
}

double FeltPasses::reach(const ProxyState& state, const FeltContacts& on, const Vec3& drop, const Vec3& slide,
                         const Hold& hold, double settled, bool mayExtend) noexcept {
    on_ = &on;
    const double atStart = slide.norm();
    way_ = slide / atStart;
    before_.clear();
    if (centre_ == state.position) before_.push({centre_, result_.x});
    const bool looks = hold.back > 0;
    const Look where = looks ? Look::AheadOverEdges : Look::AheadInPlane;
    const double heldAtStart = looks ? held(way_) : 0; // the update looked there
    Ahead begin{0, atStart}, last = begin;
    const auto wishAfter = [&](double part) {
        double wish = at(state.position + (drop + part * slide), where).x.dot(way_);
        if (looks) wish -= hold.back + held(way_) - heldAtStart;
        if (looks && hold.lag > 0) {
            // Where the viscosity changes on the way, too, the mean of both ends holds the slide.
            const double length = atStart * 2 * hold.lag / (hold.lag + lag());
            wish += (1 - hold.followed) * (length - part * atStart - wish);
        }
        const double secant = (part - last.part) * atStart / (last.wish - wish);
        leads_ = secant > 0 ? std::min(secant, kFarthest) : 1;
        last = {part, wish};
        return wish;
    };
    Ahead end{1, wishAfter(1)};
    // Without friction comeToRest() goes the rest.
    const double most = looks ? settled : settled / (kLeftOver + std::abs(leads_ - 1)),
                 near = std::max(kOvershoot * atStart, most);
    // What rubs does not come back from where it went too far: there nobody goes without a look, nor where
    // one sees less friction because the face that is touched ends.
    const auto isOnFace = [](const Contact& contact) { return contact.bend == 0; };
    const bool goesOn = !looks || std::ranges::all_of(on.contacts, isOnFace);
    if (mayExtend && goesOn && end.wish > most && end.wish < atStart) {
        const double farther = std::min(atStart / (atStart - end.wish), kFarthest);
        if (!looks) return farther;
        begin = end;
        end = {farther, wishAfter(farther)};
    }
    return end.wish >= -near ? end.part : turningPoint(begin, end, near, wishAfter);
}

// On one plane what is wished changes nearly evenly over the plane: along the way as the secant of its last
// two places says, and in both directions once it was looked aside.
FeltPasses::Rest FeltPasses::rest() noexcept {
    const Vec3& wish = result_.x;
    const std::optional<Vec3> known = root();
    const Vec3 way = known.value_or(leads_ * wish), aside = wish - wish.dot(way_) * way_;
    const double leaves =
        kLeftOver * wish.norm() + (way - wish).norm() + (known ? 0 : kLeftOverAside * aside.norm());
    return {isFree(way) ? way : wish, leaves};
}

// Where nothing is wished if it changes evenly between the last three places. Nothing where these lie on a
// line.
std::optional<Vec3> FeltPasses::root() const noexcept {
    if (before_.size() < 2) return std::nullopt;
    const Vec3 &x = result_.x, y = before_[0].way - x, z = before_[1].way - x;
    const double yy = y.squaredNorm(), zz = z.squaredNorm(), yz = y.dot(z), det = yy * zz - yz * yz;
    if (!(det > kSameWay * yy * zz)) return std::nullopt;
    const double a = (yz * z.dot(x) - zz * y.dot(x)) / det, b = (yz * y.dot(x) - yy * z.dot(x)) / det;
    const Vec3 way = a * (before_[0].place - centre_) + b * (before_[1].place - centre_);
    return way.norm() < kFarthestRoot * x.norm() ? std::optional(way) : std::nullopt;
}

void FeltPasses::lookOn(const Vec3& place) noexcept {
    if (before_.size() == 2) {
        const Wish last = before_[1];
        before_.clear();
        before_.push(last);
    }
    before_.push({centre_, result_.x});
    at(place, Look::AheadInPlane);
}

bool FeltPasses::comeToRest(const FeltContacts& on, const Vec3& from, Vec3& motion, double settled) noexcept {
    if (centre_ != from + motion) return false;
    on_ = &on;
    for (int looks = 0; hasLookedAt(on.contacts); ++looks) {
        const auto [way, leaves] = rest();
        const Vec3 next = motion + way;
        if (!isAbove(on.contacts, next, settled)) return false;
        if (leaves <= settled) {
            motion = next;
            return true;
        }
        if (looks == kLooksOn || way.norm() > kFarthestAside * motion.norm()) return false;
        const double before = result_.x.norm();
        lookOn(from + next);
        if (!(result_.x.norm() < kNearer * before)) return false;
        motion = next;
    }
    return false;
}

} // namespace tactum
