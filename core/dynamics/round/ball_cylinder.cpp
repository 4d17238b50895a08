#include "core/dynamics/round/pairs.h"

namespace tactum {

std::optional<TouchPoints> ballAndCylinder(const RoundBody& a, const RoundBody& b, double margin) noexcept {
    TouchPoints points;
    const Clearance clear = fromCylinder(b, a.centre);
    keep(points, a.centre - a.radius * clear.out, -clear.out, clear.gap - a.radius, margin);
    return points;
}

} // namespace tactum
