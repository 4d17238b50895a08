#include "core/port/reach_tracker.h"

namespace tactum {

Vec3 wayAlong(const Vec3& way, const Vec3& finger, std::span<const Wall> walls) noexcept {
    constexpr double kTouches = 1e-12; // m
    const auto into = [&](const Wall& wall, const Vec3& along) {
        return std::max(0.0, wall.normal.dot(finger) - wall.offset) + wall.normal.dot(along);
    };
    Vec3 along = way;
    for (std::size_t round = 0; round < walls.size(); ++round)
        for (const Wall& wall : walls)
            along -= std::min(0.0, into(wall, along)) * wall.normal;
    for (const Wall& wall : walls)
        if (!(into(wall, along) >= -kTouches)) return Vec3::Zero();
    return along;
}

void ReachTracker::decide(const Reach& reach) noexcept {
    if (reach == reach_) return;
    reach_ = reach;
    resting_ = true;
}

double ReachTracker::shell() const noexcept {
    return radius_ > 0 ? std::min(reach_.shell, kShellMost * radius_) : reach_.shell;
}

void ReachTracker::rest(const Vec3& position) noexcept {
    resting_ = true;
    border_ = std::max(shell(), position.norm());
    held_ = position;
}

Vec3 ReachTracker::way(const Vec3& position, double dt) noexcept {
    if (resting_) rest(position);
    resting_ = false;
    if (reach_.mode == ReachMode::Drift) return drift(position);
    if (reach_.mode != ReachMode::Rate) return Vec3::Zero();
    const double distance = position.norm();
    border_ = std::max(shell(), std::min(border_, distance));
    if (!(distance > border_)) return Vec3::Zero();
    return rateSpeed(distance - border_) * dt / distance * position;
}

/// A hand at rest whose reading goes to and fro between two counts moves nothing.
Vec3 ReachTracker::drift(const Vec3& position) noexcept {
    const double moved = (position - held_).norm();
    if (!(moved > 1.5 * resolution_)) return Vec3::Zero();
    held_ = position;
    const double radius = radius_ > 0 ? radius_ : kUsualShell;
    return kDriftPart * std::min(1.0, position.norm() / radius) * moved * position.stableNormalized();
}

} // namespace tactum
