#include "core/dynamics/round/pairs.h"

namespace tactum {

std::optional<TouchPoints> ballAndBall(const RoundBody& a, const RoundBody& b, double margin) noexcept {
    TouchPoints points;
    const Vec3 between = b.centre - a.centre;
    const double distance = between.norm();
    const Vec3 normal = distance > 1e-12 * a.radius ? Vec3(between / distance) : Vec3::UnitY();
    keep(points, a.at(0) + a.radius * normal, normal, distance - a.radius - b.radius, margin);
    return points;
}

} // namespace tactum
