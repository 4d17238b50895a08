// One haptic step: finger in, proxy and force out. A plain function, the same in the proxy loop, in tests,
// in replay and on the command line.
#pragma once

#include <array>
#include <cstdint>

#include "core/base/vec.h"
#include "core/dynamics/body_motion.h"
#include "core/proxy/nearest_point.h"
#include "core/proxy/proxy.h"
#include "core/runtime/world.h"
#include "core/surface/friction.h"

namespace tactum {

/// More planes than push at once (three); the rest would be nearly parallel to them.
inline constexpr int kMaxModelPlanes = 4;

/// What is known of the finger at this step. World frame, SI.
struct HapticInput {
    Vec3 finger = Vec3::Zero();
    Vec3 fingerVelocity = Vec3::Zero();
};

/// The surroundings of the proxy in a form that the servo renders between proxy updates, so that free
/// motion does not drag and contact keeps the servo's rate (sections 7 and 8). World frame, SI.
struct LocalContactModel {
    Vec3 proxy = Vec3::Zero();
    int planes = 0;
    std::array<ConstraintPlane, kMaxModelPlanes> plane{}; ///< offset relative to `proxy`
    std::array<FrictionLimit, kMaxModelPlanes> friction{};
    double stiffness = 0;         ///< N/m
    double damping = 0;           ///< N s/m
    Vec3 velocity = Vec3::Zero(); ///< m/s, of what is touched: damping is against the motion relative to it
    bool valid = false;           ///< false: no step has run yet
};

/// One touched place, for the display.
struct ContactReport {
    Vec3 point = Vec3::Zero();  ///< on the surface, world frame
    Vec3 normal = Vec3::Zero(); ///< out of the surface toward the proxy
    double normalForce = 0;     ///< N (equation 19)
    std::uint32_t body = 0;     ///< index into World::bodies
    std::uint32_t surface = 0;  ///< index into the object's surfaces
    bool slipping = false;
};

struct HapticOutput {
    Vec3 proxy = Vec3::Zero(); ///< world frame
    Vec3 force = Vec3::Zero(); ///< N on the finger, before the device's limit
    int contacts = 0;          ///< how many planes push, at most kMaxModelPlanes
    std::array<ContactReport, kMaxModelPlanes> contact{};
    ProxyReport report;
};

/// All that changes at haptic rate.
struct SimState {
    ProxyState proxy;
    LocalContactModel model;                         ///< written by the step for the servo
    std::uint64_t shapeRevision = ~std::uint64_t(0); ///< of the World that the contacts belong to
    /// s since the motions began: the end of the last step. It goes on through every change of the World, so
    /// that an edit does not make bodies jump.
    double time = 0;
    std::array<BodyMotion, kMaxMovers> movers{}; ///< in the order of World::movers
};

/// Carries, moves and updates the proxy (sections 2 and 4) and computes the force on the finger (24).
/// Bodies that move by themselves go on by dt. Deterministic: the same world, state, input and dt give the
/// same bits. dt in s, > 0. After a change of shape, and at first, the proxy starts on the finger. Input that
/// is not finite changes nothing and gives no force. Thread: real time. Bounded: at most kMaxRounds sweeps of
/// each body.
HapticOutput hapticStep(const World& world, SimState& state, const HapticInput& input, double dt) noexcept;

/// The force that a local contact model gives a finger: N, world frame, before the device's limit.
/// Thread: real time.
Vec3 contactModelForce(const LocalContactModel& model, const Vec3& finger_W, const Vec3& velocity_W) noexcept;

} // namespace tactum
