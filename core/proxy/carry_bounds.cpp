#include "core/proxy/carry_bounds.h"

namespace tactum {

std::optional<CarryBounds::Place> CarryBounds::nearestTo(const Vec3& goal, double radius) const noexcept {
    if (const NearestPoint whole = nearest(goal, 0); whole.feasible) return Place{goal + whole.x, 0};
    double low = 0, high = kMaxGive * radius;
    NearestPoint best = nearest(goal, high);
    if (!best.feasible) return std::nullopt;
    constexpr int kHalvings = 40; // to the last bits of a radius
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (low + high);
        const NearestPoint tried = nearest(goal, middle);
        (tried.feasible ? high : low) = middle;
        if (tried.feasible) best = tried;
    }
    return Place{goal + best.x, high};
}

NearestPoint CarryBounds::nearest(const Vec3& goal, double give) const noexcept {
    std::array<ConstraintPlane, kMaxPlanes> planes;
    for (int i = 0; i < count_; ++i) {
        const ConstraintPlane& plane = bounds_[std::size_t(i)].plane;
        planes[std::size_t(i)] = {plane.normal, plane.offset - give - plane.normal.dot(goal)};
    }
    return nearestPoint(Vec3::Zero(), {planes.data(), std::size_t(count_)});
}

} // namespace tactum
