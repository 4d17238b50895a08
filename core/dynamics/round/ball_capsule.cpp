#include <algorithm>

#include "core/dynamics/round/pairs.h"

namespace tactum {

// A capsule is to a ball what one of its balls is.
std::optional<TouchPoints> ballAndCapsule(const RoundBody& a, const RoundBody& b, double margin) noexcept {
    const double along = std::clamp(b.alongOf(a.centre), -b.half, b.half);
    return ballAndBall(a, {b.at(along), b.axis, 0, b.radius}, margin);
}

} // namespace tactum
