// One haptic step: finger in, proxy and force out. A plain function, the same in the proxy loop, in tests,
// in replay and on the command line.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/base/vec.h"
#include "core/haptics/contact_model.h"
#include "core/haptics/world.h"
#include "core/proxy/proxy.h"

namespace tactum {

/// What is known of the finger at this step. World frame, SI.
struct HapticInput {
    Vec3 finger = Vec3::Zero();
    Vec3 fingerVelocity = Vec3::Zero();
    bool restart = false; ///< first put the proxy onto the finger, or beside it where something is
    Fidelity fidelity = Fidelity::Full;
    /// Nobody knows which way the finger came: as `restart`, but closed bodies that the proxy was outside of
    /// it stays outside of.
    bool found = false;
    Coupling coupling{}; ///< what of the force the hand gets: what is beyond it reaches no body either
};

/// How time goes for the bodies in a step, whoever touches them.
struct BodiesTime {
    double pace = 1;    ///< of their time to that of the hands; 0: they stand still. From 0 to 1
    bool begin = false; ///< first put all of them to where they are at the time 0
};

/// One touched place, for the display.
struct ContactReport {
    Vec3 point = Vec3::Zero();  ///< on the surface, world frame
    Vec3 normal = Vec3::Zero(); ///< out of the surface toward the proxy
    double normalForce = 0;     ///< N (equation 19)
    std::uint32_t body = 0;     ///< index into World::bodies
    std::uint32_t surface = 0;  ///< index into the object's surfaces
    bool slipping = false;
    bool frictionless = false; ///< it neither sticks nor slips: the surface there has no friction at all
    // Coefficients there, as texture layers have made them; ratios.
    double staticFriction = 0, dynamicFriction = 0;
};

struct HapticOutput {
    Vec3 proxy = Vec3::Zero(); ///< world frame
    Vec3 force = Vec3::Zero(); ///< N on the finger, before the device's limit
    int contacts = 0;          ///< how many planes push, at most kMaxModelPlanes
    std::array<ContactReport, kMaxModelPlanes> contact{};
    ProxyReport report;
};

/// The shapeRevision of no World: the next step is the first.
inline constexpr std::uint64_t kNoShape = ~std::uint64_t(0);

/// What changes at haptic rate of one hand.
struct HandState {
    ProxyState proxy;
    LocalContactModel model;                ///< written by the step for the servo
    std::uint64_t shapeRevision = kNoShape; ///< of the World that the contacts belong to
    std::uint32_t restarts = 0;             ///< how often the proxy was put elsewhere instead of going there
    FingerPress press;                      ///< of the last step
};

/// What changes at haptic rate of what all hands touch.
struct WorldState {
    /// s since the motions began: the end of the last step. It goes on through every change of the World, so
    /// that an edit does not make bodies jump.
    double time = 0;
    BodiesState bodies; ///< that forces move
};

/// One hand, and what it touches alone.
struct SimState : HandState, WorldState {};

/// One of the hands in a step: what goes in, and what comes out.
struct HandStep {
    HandState& state;
    HapticInput input;
    HapticOutput output{};
};

/// Carries, moves and updates the proxy of each hand (sections 2 and 4) and computes the force on its finger
/// (24). Bodies that move by themselves go on by dt, those that forces move under the opposite of the last
/// forces on all fingers (23); each finger then meets them where they are. Proxies do not meet each other.
/// Deterministic: the same world, states, inputs, order of hands and dt give the same bits. At most kMaxHands
/// hands, dt in s, > 0. At first a proxy starts on its finger; after a change of shape it stays. Both only
/// where there is room: else it starts beside what is there. A hand whose input is not finite stays as it is,
/// gets no force and gives none; where that is every hand nothing changes. Thread: real time. Bounded: for
/// each hand at most kMaxRounds sweeps of each body, and where bodies move by themselves those of carry()
/// before them.
void hapticStep(const World& world, WorldState& shared, std::span<HandStep> hands, double dt,
                const BodiesTime& bodies = {}) noexcept;
/// The same for one hand.
HapticOutput hapticStep(const World& world, SimState& state, const HapticInput& input, double dt,
                        const BodiesTime& bodies = {}) noexcept;

/// Makes the next step of a hand as it is likely to be, but with few rounds, on a copy of what changes: what
/// of the mesh and of the program it will need is in the caches then. Neither the world nor a state changes,
/// and so no bit of any step. `time`: WorldState::time. `next`: the finger as it will be. `copy`: room for
/// the copy, which is too large for a stack; what it holds is lost. Thread: real time; as long as kFewRounds
/// of a step.
void rehearse(const World& world, const HandState& state, double time, const HapticInput& next, double dt,
              HandState& copy) noexcept;

} // namespace tactum
