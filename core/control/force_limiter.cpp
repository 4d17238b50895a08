#include "core/control/force_limiter.h"

namespace tactum {

Vec3 ForceLimiter::operator()(const Vec3& force) noexcept {
    if (!force.allFinite()) {
        ++notFinite;
        return Vec3::Zero();
    }
    // stableNorm: the square of a large finite component must not overflow to infinity.
    const double magnitude = force.stableNorm();
    if (magnitude <= maxForce) return force;
    ++clamped;
    // Scaling rounds; half an ulp above the limit is still above the limit.
    return force * (maxForce / magnitude) * (1 - 4e-16);
}

} // namespace tactum
