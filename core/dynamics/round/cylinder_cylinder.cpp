#include <algorithm>

#include "core/dynamics/round/pairs.h"

namespace tactum {

namespace {

/// Deeper than this part of the thinner one the sides may not be the least way out.
constexpr double kDeep = 0.1;

/// The place on the rim of an end that is next to the side of the other one, and how far from it.
struct RimPlace {
    Vec3 point = Vec3::Zero();
    Clearance clear;
};
RimPlace rimAt(const RoundBody& of, double along, const RoundBody& other) noexcept {
    const Vec3 end = of.at(along), out = fromSide(other, end).out;
    const Vec3 point = end - of.radius * (out - out.dot(of.axis) * of.axis).normalized();
    Clearance clear = fromSide(other, point);
    if (clear.out.dot(out) < 0) clear.gap = -other.radius; // beyond the axis: deep inside
    return {point, clear};
}

/// At an end of the stretch that both have of the axis of a: of whichever cylinder ends there.
TouchPoint endOfStretch(const RoundBody& a, const RoundBody& b, double along) noexcept {
    if (std::abs(along) >= a.half) {
        const RimPlace rim = rimAt(a, along, b);
        return {rim.point - 0.5 * rim.clear.gap * rim.clear.out, -rim.clear.out, rim.clear.gap};
    }
    const double end = b.alongOf(a.at(along)) > 0 ? b.half : -b.half;
    const RimPlace rim = rimAt(b, end, a);
    return {rim.point - 0.5 * rim.clear.gap * rim.clear.out, rim.clear.out, rim.clear.gap};
}

/// Where the sides of two cylinders that cross are nearest; nothing where one ends before.
std::optional<TouchPoint> crossing(const RoundBody& a, const RoundBody& b) noexcept {
    const Vec3 across = a.axis.cross(b.axis), between = b.centre - a.centre;
    const double square = across.squaredNorm();
    const double onA = between.cross(b.axis).dot(across) / square,
                 onB = between.cross(a.axis).dot(across) / square;
    if (std::abs(onA) > a.half || std::abs(onB) > b.half) return std::nullopt;
    const Vec3 up = across / std::sqrt(square), normal = between.dot(up) < 0 ? Vec3(-up) : up;
    const double gap = std::abs(between.dot(up)) - a.radius - b.radius;
    return TouchPoint{a.at(onA) + (a.radius + 0.5 * gap) * normal, normal, gap};
}

} // namespace

// Side against side. What touches with an end, flat or by its rim, is for the polytopes.
std::optional<TouchPoints> cylinderAndCylinder(const RoundBody& a, const RoundBody& b,
                                               double margin) noexcept {
    const double skew = a.axis.cross(b.axis).norm(), deep = -kDeep * std::min(a.radius, b.radius);
    InplaceVector<TouchPoint, 3> found;
    double room = b.half + a.half; // beyond what is deeper than they lie side by side an end is the way out
    if (skew < kAlongside) {
        const Stretch shared = sharedStretch(a, b);
        if (shared.length() <= 0) return std::nullopt;
        room = shared.length();
        for (const double along : {shared.low, shared.high})
            found.push(endOfStretch(a, b, along));
    }
    if (skew > kParallel)
        if (const auto point = crossing(a, b)) found.push(*point);
    if (found.size() == 0) return std::nullopt;
    TouchPoints points;
    for (const TouchPoint& point : found.all()) {
        if (point.gap < std::max(deep, -room)) return std::nullopt;
        if (point.gap <= margin) points.push(point);
    }
    return points;
}

} // namespace tactum
