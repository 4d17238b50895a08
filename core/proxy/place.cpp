#include "core/proxy/place.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/collision/nearest.h"
#include "core/proxy/near_bodies.h"
#include "core/proxy/proxy.h"

namespace tactum {
namespace {

constexpr int kPushes = 16;    ///< in a right-angled corner three are enough
constexpr int kDoublings = 24; ///< from a radius of a millimetre to beyond every scene
/// Of the radius: pushed so far beyond touching that the pushes of a corner come to an end.
constexpr double kClear = 1e-3;
/// Of the radius: what is nearer than this lies on the surface.
constexpr double kOn = 1e-6;

struct Placing {
    std::span<const Obstacle> obstacles;
    const StepMotions& movers;
    double radius;
    FormerPlace former;
    const NearBodies* bodies; ///< null: look at every obstacle

    bool mayNotEnter(const Obstacle& obstacle) const noexcept;
    Vec3 pushOff(const Obstacle& obstacle, const Vec3& p_W) const noexcept;
    Vec3 largestPush(const Vec3& p_W) const noexcept;
    bool isClear(const Vec3& p_W) const noexcept { return largestPush(p_W).isZero(0); }
    Vec3 nearestOnWay(const Vec3& from_W, const Vec3& to_W) const noexcept;
};

/// What has a surface that is not felt can be entered there.
bool isClosed(const Obstacle& obstacle) noexcept {
    return obstacle.mesh->closed && std::ranges::find(obstacle.sides, Sides::None) == obstacle.sides.end();
}

/// Whether a proxy inside of a closed obstacle cannot have come there by itself.
bool Placing::mayNotEnter(const Obstacle& obstacle) const noexcept {
    if (obstacle.placedIn > former.since) return true;
    return former.at_W &&
           nearestOn(*obstacle.mesh, poseNow(obstacle, movers).applyInverse(*former.at_W)).front > 0;
}

/// The way out of one obstacle; zero when it is not overlapped.
Vec3 Placing::pushOff(const Obstacle& obstacle, const Vec3& p_W) const noexcept {
    const Pose pose = poseNow(obstacle, movers);
    const Vec3 p_B = pose.applyInverse(p_W);
    const bool mayBeInside = isClosed(obstacle) && (obstacle.placedIn > former.since || former.at_W);
    const double reach = mayBeInside ? std::numeric_limits<double>::infinity() : radius;
    const Nearest near = nearestOn(*obstacle.mesh, p_B, reach, obstacle.sides);
    if (!std::isfinite(near.distance)) return Vec3::Zero();
    const bool inside = mayBeInside && near.front < 0 && mayNotEnter(obstacle);
    if (!inside && near.distance >= (1 - 2 * kSkin) * radius) return Vec3::Zero();

    const Triangle shape = obstacle.triangle(near.triangle);
    const Vec3 normal = (shape.b - shape.a).cross(shape.c - shape.a).normalized();
    // So near to the surface the way from it is mostly rounding.
    const bool on = near.distance <= kOn * radius;
    Vec3 out = on ? normal : Vec3((p_B - near.point) / near.distance);
    if (inside && !on) out = -out;
    if (out.isZero(0)) out = Vec3::UnitZ(); // on a segment or a point: any way will do
    return pose.rotate(near.point + radius * (1 + kClear) * out - p_B);
}

Vec3 Placing::largestPush(const Vec3& p_W) const noexcept {
    Vec3 largest = Vec3::Zero();
    // Who is inside of an obstacle is within its box.
    forEachNear(bodies, obstacles.size(), p_W, radius, [&](std::uint32_t body) {
        const Vec3 push = pushOff(obstacles[body], p_W);
        if (push.squaredNorm() > largest.squaredNorm()) largest = push;
    });
    return largest;
}

/// How near a proxy that starts clear of everything comes on a straight way.
Vec3 Placing::nearestOnWay(const Vec3& from_W, const Vec3& to_W) const noexcept {
    double t = 1;
    const double wide = radius * (1 + kClear), half = 0.5 * (to_W - from_W).norm();
    forEachNear(bodies, obstacles.size(), 0.5 * (from_W + to_W), half + wide, [&](std::uint32_t body) {
        const Obstacle& obstacle = obstacles[body];
        const Pose pose = poseNow(obstacle, movers);
        const Vec3 from_B = pose.applyInverse(from_W);
        const SpherePath path{from_B, pose.applyInverse(to_W) - from_B, wide, obstacle.sides};
        t = std::min(t, obstacle.mesh->tree.sweep(*obstacle.mesh->soup, path, {}).t);
    });
    return from_W + t * (to_W - from_W);
}

} // namespace

std::optional<Vec3> clearPlace(std::span<const Obstacle> obstacles, const StepMotions& movers, double radius,
                               const Vec3& wanted_W, const FormerPlace& former,
                               const NearBodies* near) noexcept {
    const Placing placing{obstacles, movers, radius, former, near};
    const Vec3 first = placing.largestPush(wanted_W);
    Vec3 place = wanted_W;
    for (int push = 0; push < kPushes; ++push) {
        const Vec3 way = push == 0 ? first : placing.largestPush(place);
        if (way.isZero(0)) return place;
        place += way;
    }
    // Pushed to and fro: straight out until there is room, then back as far as it goes.
    for (int i = 0; i < kDoublings; ++i) {
        const Vec3 beyond = wanted_W + std::ldexp(radius, i) * first.normalized();
        if (placing.isClear(beyond)) return placing.nearestOnWay(beyond, wanted_W);
    }
    return std::nullopt;
}

} // namespace tactum
