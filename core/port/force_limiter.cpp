#include "core/port/force_limiter.h"

namespace tactum {
namespace {

/// Rounding may leave a scaled vector some units in the last place above the limit; this keeps it below.
constexpr double kRoundingMargin = 1 - 1e-15;

/// Dividing by the largest component first: the square of a large one must not overflow to infinity.
Vec3 directionOf(const Vec3& force) noexcept {
    return (force / force.cwiseAbs().maxCoeff()).normalized();
}

} // namespace

Vec3 ForceLimiter::operator()(const Vec3& force) noexcept {
    if (!force.allFinite()) {
        ++notFinite;
        return Vec3::Zero();
    }
    // A limit that is no number limits to nothing.
    const double limit = maxForce > 0 ? maxForce : 0;
    if (force.stableNorm() <= limit) return force;
    ++clamped;
    return directionOf(force) * (limit * kRoundingMargin);
}

} // namespace tactum
