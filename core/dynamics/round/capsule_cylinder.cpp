#include <algorithm>

#include "core/dynamics/joint.h"
#include "core/dynamics/round/pairs.h"

namespace tactum {

namespace {

constexpr int kHalvings = 40;

/// The distance from what is convex is convex along the axis, also inside: it falls up to one place and rises
/// from there, and so halving finds that place.
double nearestPlace(const RoundBody& capsule, const RoundBody& cylinder) noexcept {
    const auto rises = [&](double along) {
        return fromCylinder(cylinder, capsule.at(along)).out.dot(capsule.axis) > 0;
    };
    double low = -capsule.half, high = capsule.half;
    if (!rises(high)) return high;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (low + high);
        (rises(middle) ? high : low) = middle;
    }
    return low;
}

/// What of the axis of a capsule is over the flat ends of a cylinder.
Stretch overEnds(const RoundBody& capsule, const RoundBody& cylinder) noexcept {
    const auto across = [&](const Vec3& v) { return Vec3(v - v.dot(cylinder.axis) * cylinder.axis); };
    const Vec3 from = across(capsule.centre - cylinder.centre), way = across(capsule.axis);
    const double square = way.squaredNorm(), middle = -from.dot(way) / square;
    const double chord = cylinder.radius * cylinder.radius - (from + middle * way).squaredNorm();
    if (!(chord > 0)) return {};
    const double half = std::sqrt(chord / square);
    return {std::max(-capsule.half, middle - half), std::min(capsule.half, middle + half)};
}

/// Along what of its axis a capsule lies on a cylinder, and may touch at both ends of that.
Stretch stretchOf(const RoundBody& capsule, const RoundBody& cylinder) noexcept {
    if (capsule.axis.cross(cylinder.axis).norm() < kAlongside) return sharedStretch(capsule, cylinder);
    const bool liesFlat = std::abs(capsule.axis.dot(cylinder.axis)) < kAlongside;
    return liesFlat ? overEnds(capsule, cylinder) : Stretch{};
}

} // namespace

std::optional<TouchPoints> capsuleAndCylinder(const RoundBody& a, const RoundBody& b,
                                              double margin) noexcept {
    TouchPoints points;
    const auto touch = [&](double along) {
        const Clearance clear = fromCylinder(b, a.at(along));
        keep(points, a.at(along) - a.radius * clear.out, -clear.out, clear.gap - a.radius, margin);
        return clear.gap;
    };
    double least = kUnbounded;
    if (const Stretch lies = stretchOf(a, b); lies.length() > 0)
        least = std::min(touch(lies.low), touch(lies.high));
    const double nearest = nearestPlace(a, b);
    if (fromCylinder(b, a.at(nearest)).gap < least - kParallel * kParallel * a.radius) touch(nearest);
    return points;
}

} // namespace tactum
