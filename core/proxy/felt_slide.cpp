// How far a slide leads over a surface whose felt normal, depth and friction change on the way. Thread: real
// time.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/proxy/felt_planes.h"
#include "core/surface/friction.h"

namespace tactum {

namespace {

// A slide is followed so many times as far as it was wished.
constexpr double kFarthest = 2;
// It is good if its end wishes no more than this part of it back.
constexpr double kOvershoot = 0.001;
constexpr int kSearches = 8;

// A place on the way of a slide, and what is wished there along it, m.
struct Wish {
    double part;
    double there;
};

// Between one that leads on and one that leads back: where the wish turns, or is shorter than `near`. The
// Illinois method, and hardly beyond the turning point: where the felt normal jumps, on the edge between two
// painted triangles, the proxy comes to rest on the side that it came from.
double turningPoint(Wish on, Wish back, double near, const auto& wishAfter) noexcept {
    for (int i = 0; i < kSearches; ++i) {
        const double middle = on.part + (back.part - on.part) * on.there / (on.there - back.there);
        const double there = wishAfter(middle);
        if (std::abs(there) <= near) return middle;
        if (there > 0) {
            on = {middle, there};
            back.there *= 0.5;
        } else {
            back = {middle, there};
            on.there *= 0.5;
        }
    }
    return on.part;
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
    const Vec3 way = slide / atStart;
    const bool looks = hold.back > 0;
    const Look where = looks ? Look::AheadOverEdges : Look::AheadInPlane;
    const double heldAtStart = looks ? held(way) : 0; // the update looked there
    Wish begin{0, atStart}, last = begin;
    const auto wishAfter = [&](double part) {
        double wish = at(state.position + (drop + part * slide), where).x.dot(way);
        if (looks) wish -= hold.back + held(way) - heldAtStart;
        if (looks && hold.lag > 0) {
            // Where the viscosity changes on the way, too, the mean of both ends holds the slide.
            const double length = atStart * 2 * hold.lag / (hold.lag + lag());
            wish += (1 - hold.followed) * (length - part * atStart - wish);
        }
        const double secant = (part - last.part) * atStart / (last.there - wish);
        leads_ = secant > 0 ? std::min(secant, kFarthest) : 1;
        last = {part, wish};
        return wish;
    };
    Wish end{1, wishAfter(1)};
    // What rubs does not come back from where it went too far: there nobody goes without a look, nor where
    // one sees less friction because the face that is touched ends.
    const auto isOnFace = [](const Contact& contact) { return contact.bend == 0; };
    const bool goesOn = !looks || std::ranges::all_of(on.contacts, isOnFace);
    if (mayExtend && goesOn && end.there > settled && end.there < atStart) {
        const double farther = std::min(atStart / (atStart - end.there), kFarthest);
        if (!looks) return farther;
        begin = end;
        end = {farther, wishAfter(farther)};
    }
    const double near = std::max(kOvershoot * atStart, settled);
    return end.there >= -near ? end.part : turningPoint(begin, end, near, wishAfter);
}

} // namespace tactum
