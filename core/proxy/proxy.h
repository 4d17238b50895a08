// The virtual proxy: the massless sphere that stays outside while the finger goes in (section 2).
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/base/vec.h"
#include "core/collision/collision_mesh.h"
#include "core/proxy/nearest_point.h"
#include "core/surface/material.h"

namespace tactum {

/// Rounds of move and update in one step. A corner needs one for each of its planes and one to settle.
inline constexpr int kMaxRounds = 24;
/// The sweep's sphere is smaller than the proxy by this part of the radius, while constraint planes hold the
/// proxy at its full radius: a slide along a flat neighbour is then never mistaken for a collision. The
/// clearance is therefore at least r (1 - kSkin): one nanometre short for a proxy of one millimetre.
inline constexpr double kSkin = 1e-6;

/// A mesh where it is now, with the feel of its surfaces.
struct Obstacle {
    const CollisionMesh* mesh = nullptr;
    Pose pose; ///< X_WB
    std::span<const Material> materials;

    Triangle triangle(Index index) const; ///< body frame
    const Material& material(Index triangleIndex) const;
};

/// A primitive that the proxy touches, with its constraint plane. World frame.
struct Contact {
    std::uint32_t body = 0; ///< index of the obstacle
    Index triangle = 0;
    bool slipping = false;
    Vec3 point = Vec3::Zero();   ///< on the surface
    Vec3 normal = Vec3::UnitZ(); ///< out of the surface toward the proxy
    double gap = 0;              ///< from the proxy's surface to `point`, m; as low as -kSkin r
    double bend = 0;             ///< curvature of the C-obstacle, 1/m: 0 over a face
    Mat3 bent = Mat3::Zero();    ///< projector onto the directions in which it bends
    double lambda = 0;           ///< multiplier of the plane, m: its force is k lambda normal (19)
};

inline constexpr std::uint32_t kNoBody = ~std::uint32_t(0);

struct ProxyState {
    Vec3 position = Vec3::Zero(); ///< world frame
    Vec3 finger = Vec3::Zero();   ///< of the last step, world frame
    std::array<Contact, kMaxPlanes> contacts{};
    int contactCount = 0;
    Index leafHint = 0; ///< where the last sweep hit: the next one looks there first
    std::uint32_t slidingOn =
        kNoBody; ///< the body that the proxy last slid on: a contact that it meets next slips
};

struct ProxyReport {
    int rounds = 0;
    bool boundHit = false; ///< kMaxRounds ended the step; the state is valid and the next step goes on
};

/// Puts the proxy onto the finger, touching nothing. Thread: real time.
void restart(ProxyState& state, const Vec3& finger_W) noexcept;

/// Moves and updates the proxy toward the finger for one step of dt seconds, r = `radius` in metres.
/// After it the clearance is at least r (1 - kSkin) to everything that the proxy was clear of before, the
/// distance to the finger has not grown, and `contacts` holds what is touched.
/// Thread: real time; at most kMaxRounds sweeps of each obstacle.
ProxyReport moveAndUpdate(ProxyState& state, std::span<const Obstacle> obstacles, double radius,
                          const Vec3& finger_W, double dt) noexcept;

} // namespace tactum
