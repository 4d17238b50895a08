#include <algorithm>

#include "core/dynamics/round/pairs.h"
#include "core/dynamics/segments.h"

namespace tactum {

std::optional<TouchPoints> capsuleAndCapsule(const RoundBody& a, const RoundBody& b, double margin) noexcept {
    TouchPoints points;
    const auto touch = [&](double along) {
        const RoundBody ball{a.at(along), a.axis, 0, a.radius};
        const std::optional<TouchPoints> one = ballAndCapsule(ball, b, margin);
        for (const TouchPoint& point : one->all())
            points.push(point);
    };
    const double skew = a.axis.cross(b.axis).norm();
    const Stretch shared = sharedStretch(a, b);
    const bool alongside = skew < kAlongside && shared.length() > 0;
    if (alongside) {
        touch(shared.low);
        touch(shared.high);
    }
    if (!alongside || skew > kParallel)
        touch(a.alongOf(nearestPoints(a.at(-a.half), a.at(a.half), b.at(-b.half), b.at(b.half)).a));
    return points;
}

} // namespace tactum
