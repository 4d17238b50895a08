#include "core/port/minimum_jerk.h"

namespace tactum {

MinimumJerk::MinimumJerk(const State& from, const Vec3& to, double seconds) noexcept
    : from_(from), to_(to), duration_(seconds) {}

MinimumJerk::State MinimumJerk::at(double seconds) const noexcept {
    if (!(seconds < duration_)) return {.position = to_};
    // In parts of the duration: the six coefficients are those of place, speed and acceleration at both ends.
    const double T = duration_, s = seconds / T;
    const Vec3 way = to_ - from_.position, v = T * from_.velocity, a = T * T * from_.acceleration;
    const Vec3 c3 = 10 * way - 6 * v - 1.5 * a, c4 = -15 * way + 8 * v + 1.5 * a,
               c5 = 6 * way - 3 * v - 0.5 * a;
    return {.position = from_.position + s * (v + s * (0.5 * a + s * (c3 + s * (c4 + s * c5)))),
            .velocity = (v + s * (a + s * (3 * c3 + s * (4 * c4 + s * 5 * c5)))) / T,
            .acceleration = (a + s * (6 * c3 + s * (12 * c4 + s * 20 * c5))) / (T * T)};
}

} // namespace tactum
