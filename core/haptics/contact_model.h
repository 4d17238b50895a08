// What the servo knows of the surroundings between two updates of the proxy, and the force that it renders.
#pragma once

#include <array>
#include <cstdint>

#include "core/base/vec.h"
#include "core/proxy/nearest_point.h"
#include "core/surface/friction.h"

namespace tactum {

/// More planes than push at once (three); the rest would be nearly parallel to them.
inline constexpr int kMaxModelPlanes = 4;

/// The surroundings of the proxy in a form that the servo renders between proxy updates, so that free
/// motion does not drag and contact keeps the servo's rate (sections 7 and 8). World frame, or the device's
/// (core/safety/model_in_device.h). SI.
struct LocalContactModel {
    Vec3 proxy = Vec3::Zero();
    int planes = 0;
    std::array<ConstraintPlane, kMaxModelPlanes> plane{}; ///< offset relative to `proxy`
    std::array<FrictionLimit, kMaxModelPlanes> friction{};
    double stiffness = 0;         ///< N/m
    double damping = 0;           ///< N s/m
    Vec3 velocity = Vec3::Zero(); ///< m/s, of what is touched: damping is against the motion relative to it
    bool valid = false;           ///< false: no step has run yet
    std::uint64_t revision = 0;   ///< of the World: another one after every edit
    std::uint32_t restarts = 0;   ///< how often the proxy was put elsewhere instead of going there
    std::uint32_t anchoring = 0;  ///< of the FingerSample that it answers
};

/// Where the model would have the proxy for this finger: the update stage of section 2.2 on its planes, held
/// back by their friction. `touching` is false when no plane pushes; the anchor is the finger then.
struct Anchor {
    Vec3 position = Vec3::Zero(); ///< world frame, m
    bool touching = false;
};

/// `since`: s since the finger that the model answers was read; for so long a viscous contact has slid on.
/// Thread: real time.
Anchor anchorOf(const LocalContactModel& model, const Vec3& finger_W, double since = 0) noexcept;

/// The force of the model's spring and damper on the finger for a proxy at `anchor_W`: N, world frame, before
/// the device's limit (equation 24). Damping only ever adds to the push. Thread: real time.
Vec3 springForce(const LocalContactModel& model, const Vec3& anchor_W, const Vec3& finger_W,
                 const Vec3& velocity_W) noexcept;

/// How much more `now` pushes along its own direction than `before` did. A reversal counts at most twice, a
/// push that only becomes weaker not at all: what is lost is no kick. Any unit. Thread: real time.
double rise(const Vec3& now, const Vec3& before) noexcept;

/// The force that a local contact model gives a finger: N, world frame, before the device's limit.
/// Thread: real time.
Vec3 contactModelForce(const LocalContactModel& model, const Vec3& finger_W, const Vec3& velocity_W) noexcept;

} // namespace tactum
