#include "core/proxy/straddled_bodies.h"

#include "core/collision/nearest.h"

namespace tactum {

namespace {

// A proxy that rests on a surface may be too near by two skins.
bool overlaps(const Obstacle& obstacle, const Vec3& at_B, double radius) noexcept {
    const double reach = (1 - 2 * kSkin) * radius;
    return !obstacle.mesh->tree.isBeyond(at_B, reach) &&
           nearestOn(*obstacle.mesh, at_B, reach, obstacle.sides).distance < reach;
}

Vec3 placeBefore(const Obstacle& obstacle, std::span<const BodyMotion> movers, const Vec3& p_W) noexcept {
    return (obstacle.mover < 0 ? obstacle.pose : movers[std::size_t(obstacle.mover)].before)
        .applyInverse(p_W);
}

} // namespace

void followStraddled(ProxyState& state, std::span<const Obstacle> obstacles,
                     std::span<const BodyMotion> movers, double radius, const Vec3& before_W) noexcept {
    int count = 0;
    std::array<StraddledBody, kMostStraddled> now;
    for (std::uint32_t body = 0; body < obstacles.size() && count < kMostStraddled; ++body) {
        const Obstacle& obstacle = obstacles[body];
        if (obstacle.sides.empty()) continue;
        if (obstacle.mover >= 0 && movers[std::size_t(obstacle.mover)].jumped) continue;
        const Vec3 at_B = poseNow(obstacle, movers).applyInverse(state.position);
        if (!overlaps(obstacle, at_B, radius)) continue;
        now[std::size_t(count++)] = {body, cameFrom(state, body, placeBefore(obstacle, movers, before_W))};
    }
    std::copy_n(now.begin(), count, state.straddled.begin());
    state.straddledCount = count;
}

} // namespace tactum
