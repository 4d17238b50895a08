#include "core/surface/friction.h"

#include <algorithm>
#include <cmath>

namespace tactum {

double slopeFactor(double lean, double up, double coefficient) noexcept {
    return 1 /
           std::max(lean * (std::sqrt(std::max(0.0, 1 - up * up)) + coefficient * up), 1 / kMaxSlopeFactor);
}

double depthOnSlope(std::span<const Push> pushes, std::size_t on, double coefficient,
                    const Vec3& way) noexcept {
    const Push& plane = pushes[on];
    double depth = 0;
    for (const Push& push : pushes)
        depth += depthShare(push.lambda, push.normal, plane.normal);
    if (!plane.felt) return depth;
    return depth * slopeFactor(plane.felt->dot(plane.normal), plane.felt->dot(way), coefficient);
}

double allowedSlide(const FrictionLimit& limit, double excess, double depth, double speed,
                    double dt) noexcept {
    const double most = excess - limit.coefficient * depth;
    if (!(most > 0)) return 0;
    if (!(limit.lag > 0)) return most;
    // Only the part of the time in which the cone was already left counts.
    const double before = most - speed * dt;
    const double start = std::max(before, 0.0);
    const double time = before < 0 ? most / speed : dt;
    const double steady = speed * limit.lag;
    const double end = steady + (start - steady) * std::exp(-time / limit.lag);
    return std::clamp(most - end, 0.0, most);
}

double followedPart(double lag, double dt) noexcept {
    if (!(lag > 0)) return 1;
    const double lags = dt / lag;
    return lags > 0 ? 1 + std::expm1(-lags) / lags : 0;
}

} // namespace tactum
