#include "core/dynamics/round/round_body.h"

#include <algorithm>

namespace tactum {

RoundBody roundBodyOf(const Convex& convex, const Pose& pose) noexcept {
    const bool isCylinder = convex.form == Convex::Form::Cylinder;
    return {pose.translation, pose.rotation * Vec3::UnitY(), convex.half,
            isCylinder ? convex.round : convex.radius};
}

Clearance fromSide(const RoundBody& cylinder, const Vec3& point) noexcept {
    const Vec3 across = point - cylinder.at(cylinder.alongOf(point));
    const double distance = across.norm();
    const bool isAside = distance > 1e-12 * cylinder.radius;
    return {distance - cylinder.radius,
            isAside ? Vec3(across / distance) : Vec3(cylinder.axis.unitOrthogonal())};
}

Clearance fromCylinder(const RoundBody& cylinder, const Vec3& point) noexcept {
    const Clearance side = fromSide(cylinder, point);
    const double along = cylinder.alongOf(point), beyond = std::abs(along) - cylinder.half;
    const Vec3 up = along < 0 ? Vec3(-cylinder.axis) : cylinder.axis;
    if (side.gap > 0 && beyond > 0) { // the rim is nearest
        const double gap = std::hypot(side.gap, beyond);
        return {gap, (side.gap * side.out + beyond * up) / gap};
    }
    return side.gap > beyond ? side : Clearance{beyond, up};
}

Stretch sharedStretch(const RoundBody& a, const RoundBody& b) noexcept {
    const double middle = a.alongOf(b.centre), half = b.half * std::abs(a.axis.dot(b.axis));
    return {std::max(-a.half, middle - half), std::min(a.half, middle + half)};
}

} // namespace tactum
