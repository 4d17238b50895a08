// The bodies that forces move, in the hand (section 6): what the finger does to them, and where they go.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/dynamics/dynamics.h"
#include "core/haptics/coupling.h"
#include "core/motion/body_motion.h"
#include "core/proxy/proxy.h"

namespace tactum {

/// Of all joints and loose bodies of a scene together: a loose body has seven.
inline constexpr int kMaxCoordinates = 1024;
/// Bodies go on by no more than this in one haptic step, however long it was, s.
inline constexpr double kMostBodyTime = 0.1;

/// So many hands at most are in one World at once.
inline constexpr int kMaxHands = 4;

/// Where the bodies are and how they move, between two steps.
struct BodiesState {
    std::uint64_t of = 0; ///< MovingBodies::key(); 0: of none
    int qs = 0, vs = 0;
    std::array<double, kMaxCoordinates> q{}, v{};
};

/// What a finger felt in a step: what it touches gets the opposite in the next one. World frame, SI.
struct FingerPress {
    Vec3 force = Vec3::Zero();    ///< N, on the finger
    Vec3 velocity = Vec3::Zero(); ///< m/s, of the finger
    Coupling coupling;            ///< who feels it
};

/// How the finger presses on one body until the next step.
struct FingerPush {
    std::uint32_t obstacle = 0;
    AppliedForce force; ///< `at` is found by MovingBodies
};
using FingerPushes = InplaceVector<FingerPush, kMaxPlanes>;

/// What the world makes of the hand (Mechanics): its pace may be slower still.
struct HandScale {
    double force = 1; ///< N on a body for each N of the finger
    double time = 1;  ///< s of the bodies for each s of the hand
};

/// The force on the finger, split over what it touches, opposite: of each contact the force k lambda n of its
/// plane (19), and what is left, which is friction and damping, in the same shares (23). A contact that
/// sticks gives way in every direction. Beyond what the hand gets all of it is less in one proportion.
/// `stiffness`: of the finger's spring, N/m. None where time stands still. Thread: real time.
FingerPushes pushesOf(const ProxyState& proxy, const FingerPress& press, double stiffness,
                      const HandScale& scale = {}) noexcept;

/// How one body moves, for who looks at it.
struct BodyReading {
    bool turns = false, slides = false; ///< it has a joint of one freedom: an angle or a way; else neither
    double value = 0, rate = 0;         ///< of that joint: rad, rad/s or m, m/s
    double force = 0; ///< what it does along that: springs, motor, friction and stops, N m or N
    double kinetic = 0, potential = 0; ///< J; of gravity, 0 at the origin
};

/// Steps the bodies of one World; its memory is what it steps in. Thread: one at a time; all but making it
/// real time.
class MovingBodies {
public:
    /// An obstacle that moves with a body.
    struct Driven {
        std::size_t body = 0; ///< of the mechanism
        Pose offset;          ///< body frame
    };

    MovingBodies(std::shared_ptr<const Mechanism> mechanism, const Vec3& gravity,
                 const HandScale& scale = {});
    /// Gives the number for Mover::driven. Thread: any but real time.
    int add(const Driven& driven);

    const std::shared_ptr<const Mechanism>& mechanism() const noexcept { return mechanism_; }
    /// Tells mechanisms apart whose coordinates mean other things; never 0.
    std::uint64_t key() const noexcept { return key_; }
    std::span<const Driven> driven() const noexcept { return driven_; }
    const Vec3& gravity() const noexcept { return gravity_; }
    const HandScale& scale() const noexcept { return scale_; }
    /// Of each driven obstacle, in the last begin() or step(). They stay where they are in memory.
    std::span<const BodyMotion> motions() const noexcept { return motions_; }

    /// Takes the bodies to where a state has them. A state of another mechanism begins at the time 0 first:
    /// true then, and what fingers did before is void.
    bool begin(BodiesState& state) noexcept;
    /// One hand presses during the next step(), beside the others that did since the last: at most kMaxHands.
    /// `drivenOf(obstacle)` is Mover::driven or -1.
    template <class DrivenOf> void press(const FingerPushes& pushes, DrivenOf&& drivenOf) noexcept {
        for (const FingerPush& push : pushes.all())
            if (const int driven = drivenOf(push.obstacle); driven >= 0) addForce(push.force, driven);
    }
    /// They go on by dt, under gravity, their joints, each other and the hands that press. Deterministic
    /// after forget(): the same state and pushes in the same order give the same bits.
    void step(BodiesState& state, double dt) noexcept;
    void forget() noexcept { dynamics_.forget(); }
    /// Of the joint of one freedom that moves a body, as in the last begin() or step(): m or rad. Nothing for
    /// any other body. Thread: any but real time.
    std::optional<double> coordinateOf(BodyId body) const;
    /// As in the last begin() or step(), while the finger pushes; of its pushes the obstacle is
    /// Mover::driven here. Nothing for what stands still. Thread: any but real time.
    std::optional<BodyReading> readingOf(BodyId body, const FingerPushes& pushes = {});

private:
    std::optional<std::size_t> indexOf(BodyId body) const;
    void addForce(AppliedForce force, int driven) noexcept;
    int partsFor(double dt) noexcept;
    void read(const BodiesState& state) noexcept;

    std::shared_ptr<const Mechanism> mechanism_;
    Vec3 gravity_;
    HandScale scale_;
    std::uint64_t key_;
    Dynamics dynamics_;
    DynamicState now_;
    std::vector<Pose> poses_; ///< of each body
    std::vector<Driven> driven_;
    std::vector<BodyMotion> motions_;
    InplaceVector<AppliedForce, std::size_t(kMaxHands) * kMaxPlanes> forces_; ///< since the last step
};

} // namespace tactum
