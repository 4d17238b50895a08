// The virtual proxy: the massless sphere that stays outside while the finger goes in (section 2).
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/base/vec.h"
#include "core/collision/collision_mesh.h"
#include "core/proxy/nearest_point.h"
#include "core/surface/friction.h"

namespace tactum {

/// Rounds of move and update in one step. A corner needs one for each of its planes and one to settle.
inline constexpr int kMaxRounds = 24;
/// The sweep's sphere is smaller than the proxy by this part of the radius, while constraint planes hold the
/// proxy at its full radius: a slide along a flat neighbour is then never mistaken for a collision. The
/// clearance is therefore at least r (1 - kSkin), one nanometre short for a proxy of one millimetre.
inline constexpr double kSkin = 1e-6;

/// A mesh where it is now, with the feel of its surfaces.
struct Obstacle {
    const CollisionMesh* mesh = nullptr;
    Pose pose; ///< X_WB
    std::span<const Material> materials;
};

/// A primitive that the proxy touches.
struct Contact {
    std::uint32_t body = 0;
    Index triangle = 0;
    bool slipping = false;
    Vec3 point = Vec3::Zero();  ///< on the surface, world frame
    Vec3 normal = Vec3::UnitZ(); ///< toward the proxy, world frame
    double gap = 0;             ///< distance of the proxy's surface, m; negative by up to kSkin r
    double lambda = 0;          ///< multiplier of the last solution, m: normal force / k
};

struct ProxyState {
    Vec3 position = Vec3::Zero(); ///< world frame
    std::array<Contact, kMaxPlanes> contacts{};
    int contactCount = 0;
};

struct ProxyReport {
    int rounds = 0;
    bool boundHit = false;
};

/// Moves and updates the proxy toward the finger for one step of dt seconds.
/// After it: clearance >= r (1 - kSkin) to every obstacle that it was clear of before; the distance to the
/// finger has not grown; contacts hold what is touched, their multipliers and stick or slip.
/// Thread: real time; at most kMaxRounds sweeps of each obstacle.
ProxyReport moveAndUpdate(ProxyState& state, std::span<const Obstacle> obstacles, double radius,
                          const Vec3& finger_W, double dt) noexcept;

} // namespace tactum
