// One haptic step: finger in, proxy and force out. A plain function, the same in the proxy loop, in tests,
// in replay and on the command line.
#pragma once

#include <array>
#include <cstdint>

#include "core/base/vec.h"
#include "core/proxy/nearest_point.h"
#include "core/proxy/proxy.h"
#include "core/runtime/world.h"

namespace tactum {

inline constexpr int kMaxModelPlanes = 4;

/// What is known of the finger at this step. World frame, SI.
struct HapticInput {
    Vec3 finger = Vec3::Zero();
    Vec3 fingerVelocity = Vec3::Zero();
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
    int contacts = 0;          ///< how many of the planes push
    std::array<ContactReport, kMaxModelPlanes> contact{};
    int iterations = 0;        ///< move and update rounds of this step
    bool boundHit = false;     ///< the fixed bound of rounds ended the step; the next one goes on
};

/// The surroundings of the proxy in a form that the servo renders between proxy updates, so that free
/// motion does not drag and contact keeps the servo's rate. World frame, SI.
struct LocalContactModel {
    Vec3 proxy = Vec3::Zero();
    int planes = 0;
    std::array<ConstraintPlane, kMaxModelPlanes> plane{}; ///< offset relative to `proxy`
    std::array<FrictionLimit, kMaxModelPlanes> friction{};
    double stiffness = 0; ///< N/m
    double damping = 0;   ///< N s/m
    bool valid = false;   ///< false: no step has run yet
};

/// All that changes at haptic rate.
struct SimState {
    ProxyState proxy;
    std::uint64_t shapeRevision = ~std::uint64_t(0); ///< of the World that the contacts belong to
    LocalContactModel model;                         ///< written by the step for the servo
};

/// Puts the proxy onto the finger and forgets every contact. Thread: real time.
void restartProxy(SimState& state, const Vec3& finger_W) noexcept;

/// Carries, moves and updates the proxy (sections 2 and 4) and computes the force on the finger (24).
/// Deterministic: the same world, state, input and dt give the same bits. dt in s, > 0.
/// Thread: real time. Bounded: at most kMaxRounds sweeps (core/proxy/proxy.h).
HapticOutput hapticStep(const World& world, SimState& state, const HapticInput& input, double dt) noexcept;

/// The force that a local contact model gives a finger: N, world frame, before the device's limit.
/// Thread: real time.
Vec3 contactModelForce(const LocalContactModel& model, const Vec3& finger_W, const Vec3& velocity_W) noexcept;

} // namespace tactum
