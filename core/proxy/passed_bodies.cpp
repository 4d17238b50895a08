#include "core/proxy/passed_bodies.h"

namespace tactum {

namespace {

// Goes toward the proxy, once straight and once along what is in the way; says whether straight was enough.
bool isBack(PassedBody& body, const Obstacle& obstacle, const Vec3& proxy_B, double radius) noexcept {
    Vec3 way = proxy_B - body.at_B;
    for (int slide = 0; slide < 2; ++slide) {
        const SpherePath path{body.at_B, way, radius, obstacle.sides};
        const SweepHit hit = obstacle.mesh->tree.sweep(*obstacle.mesh->soup, path, {});
        if (hit.t > 1) {
            body.at_B += way;
            return slide == 0;
        }
        // A little short of the surface, so that the next sweep starts outside.
        body.at_B += std::max(0.0, hit.t - kSkin) * way;
        const Vec3 point = closestPoint(obstacle.triangle(hit.triangle), body.at_B).point;
        const Vec3 normal = (body.at_B - point).normalized();
        way = proxy_B - body.at_B;
        way -= way.dot(normal) * normal;
    }
    return false;
}

} // namespace

void followPassed(ProxyState& state, std::span<const Obstacle> obstacles, const StepMotions& movers,
                  double radius) noexcept {
    int kept = 0;
    for (int i = 0; i < state.passedCount; ++i) {
        PassedBody body = state.passed[std::size_t(i)];
        const Obstacle& obstacle = obstacles[body.body];
        const Vec3 proxy_B = poseNow(obstacle, movers).applyInverse(state.position);
        if (!isBack(body, obstacle, proxy_B, radius)) state.passed[std::size_t(kept++)] = body;
    }
    state.passedCount = kept;
}

} // namespace tactum
