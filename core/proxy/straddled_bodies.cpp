#include "core/proxy/straddled_bodies.h"

#include "core/collision/nearest.h"
#include "core/proxy/near_bodies.h"

namespace tactum {

namespace {

// A proxy that rests on a surface may be too near by two skins.
bool overlaps(const Obstacle& obstacle, const Vec3& at_B, double radius) noexcept {
    const double reach = (1 - 2 * kSkin) * radius;
    return !obstacle.mesh->tree.isBeyond(at_B, reach) &&
           nearestOn(*obstacle.mesh, at_B, reach, obstacle.sides).distance < reach;
}

// What jumps farther than the proxy is wide is put there; a lesser jump is swept like a motion.
bool isPut(const Obstacle& obstacle, const StepMotions& movers, double radius, const Vec3& at_W) noexcept {
    if (obstacle.mover < 0) return false;
    const BodyMotion motion = movers.of(obstacle.mover);
    return motion.jumped && (motion.carried(at_W) - at_W).norm() > 2 * radius;
}

Pose poseAt(const Obstacle& obstacle, const StepMotions& movers, double part) noexcept {
    if (obstacle.mover < 0) return obstacle.pose;
    const BodyMotion motion = movers.of(obstacle.mover);
    return part >= 1 || motion.before == motion.now ? motion.now : motion.between(part);
}

template <class Unwanted>
void follow(ProxyState& state, std::span<const Obstacle> obstacles, const StepMotions& movers, double radius,
            const Vec3& before_W, double from, double to, const NearBodies* near,
            Unwanted&& unwanted) noexcept {
    int count = 0;
    std::array<StraddledBody, kMaxStraddled> now;
    forEachNear(near, obstacles.size(), state.position, radius, [&](std::uint32_t body) {
        const Obstacle& obstacle = obstacles[body];
        if (count == kMaxStraddled || obstacle.sides.empty() || unwanted(obstacle)) return;
        const Vec3 at_B = poseAt(obstacle, movers, to).applyInverse(state.position);
        if (!overlaps(obstacle, at_B, radius)) return;
        const Vec3 before_B = poseAt(obstacle, movers, from).applyInverse(before_W);
        now[std::size_t(count++)] = {body, cameFrom(state, body, before_B)};
    });
    std::copy_n(now.begin(), count, state.straddled.begin());
    state.straddledCount = count;
}

} // namespace

void followCarried(ProxyState& state, std::span<const Obstacle> obstacles, const StepMotions& movers,
                   double radius, const Vec3& before_W, double from, double to,
                   const NearBodies* near) noexcept {
    follow(state, obstacles, movers, radius, before_W, from, to, near,
           [&](const Obstacle& obstacle) { return isPut(obstacle, movers, radius, before_W); });
}

void followMoved(ProxyState& state, std::span<const Obstacle> obstacles, const StepMotions& movers,
                 double radius, const Vec3& before_W, const NearBodies* near) noexcept {
    follow(state, obstacles, movers, radius, before_W, 1, 1, near, [](const Obstacle&) { return false; });
}

} // namespace tactum
