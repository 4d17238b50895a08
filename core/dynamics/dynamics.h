// One step in time of bodies and joints: smooth forces by Runge and Kutta's fourth order, what is not smooth
// by impulses.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/dynamics/articulation.h"
#include "core/dynamics/loops.h"
#include "core/dynamics/rows.h"

namespace tactum {

/// All that changes. As many numbers as the mechanism has.
struct DynamicState {
    Coordinates q, v;
    double time = 0; ///< s
};

/// A force on a material point. World frame.
struct AppliedForce {
    Place at;
    Vec3 force_W = Vec3::Zero(); ///< N
    /// Of a force that an elastic finger presses with: so much less for each metre that the point gives way
    /// from where it was, N/m; 0: it is constant. It never becomes a pull.
    double stiffness = 0;
    /// So much less for each m/s that the point goes faster than `velocity_W`, N s/m.
    double damping = 0;
    Vec3 velocity_W = Vec3::Zero(); ///< of who presses, m/s
    Vec3 start_W = Vec3::Zero();    ///< where the point is when the force is `force_W`, m
    Vec3 into_W = Vec3::UnitZ();    ///< of unit length: the way that it presses
    bool sticks = false;            ///< it gives way in every direction, and not along `into_W` alone

    /// N, while the point is at `now_W` and goes with `rate_W`. Thread: real time.
    Vec3 forceAt(const Vec3& now_W, const Vec3& rate_W) const noexcept;
};

struct BodyState {
    Pose pose;                           ///< X_W of the body's own frame
    Vec3 centre = Vec3::Zero();          ///< of mass, m, world frame
    Vec3 velocity = Vec3::Zero();        ///< of the centre, m/s, world frame
    Vec3 angularVelocity = Vec3::Zero(); ///< rad/s, world frame
    double kinetic = 0;                  ///< J
    double potential = 0;                ///< J, of gravity; 0 at the origin
};

/// The largest step that is taken at once; longer ones are cut, s.
inline constexpr double kLongestPart = 5e-3;

/// Thread: one at a time; step() real time, without allocation.
class Dynamics {
public:
    explicit Dynamics(std::shared_ptr<const Mechanism> mechanism);

    const Mechanism& mechanism() const noexcept { return *mechanism_; }
    DynamicState startState() const;

    /// Goes on by dt > 0. Deterministic: the same state and forces give the same bits.
    void step(DynamicState& state, const Vec3& gravity, std::span<const AppliedForce> forces,
              double dt) noexcept;

    /// What touches begins anew: the next step does not know what the last one found. Steps from a state are
    /// the same bits whatever was stepped before. Thread: real time.
    void forget() noexcept { rows_.forget(); }
    /// In how many steps so far speeds went beyond what numbers hold, and all stood still instead. Thread:
    /// that of the steps.
    std::uint64_t stoodStill() const noexcept { return stoodStill_; }
    /// Places that touched and that there was no room for, in all steps so far. Thread: that of the steps.
    std::uint64_t contactsLeftOut() const noexcept { return rows_.leftOut(); }
    /// How hard a material point is to move along a unit vector, 1 / (J M^-1 J^T) of section 6: kg; endless
    /// where nothing gives way. Thread: real time.
    double effectiveMass(const DynamicState& state, const Place& at, const Vec3& along_W) noexcept;
    /// Where each body's frame is. Thread: real time.
    void posesOf(const DynamicState& state, std::span<Pose> bodies) noexcept;
    /// Of each body of the mechanism, in its order.
    void describe(const DynamicState& state, const Vec3& gravity, std::span<BodyState> bodies) noexcept;
    /// What the springs hold: J. Of dampers and motors nothing.
    double springEnergy(const DynamicState& state) noexcept;
    /// What a joint does along the one coordinate of a link, in a step of dt from a state: its springs,
    /// detents, dampers, motors, dry friction and stops together, N or N m. Thread: real time.
    double jointForce(const DynamicState& state, const Vec3& gravity, std::span<const AppliedForce> forces,
                      double dt, int link) noexcept;
    /// The largest gap of a loop in a state, m or rad.
    double loopGap(const DynamicState& state) noexcept;
    /// Joint accelerations in a state: M^-1 (Gamma - b - g) of (22), with the loops closed.
    void accelerations(const DynamicState& state, const Vec3& gravity, std::span<const AppliedForce> forces,
                       Coordinates& acceleration) noexcept;

private:
    struct Surroundings {
        Vec3 gravity;
        std::span<const AppliedForce> forces;
        double dt = 0; ///< s, of the step or of what is left of it
    };

    void evaluate(const Coordinates& q, const Coordinates& v, const Surroundings& around,
                  Coordinates& acceleration) noexcept;
    struct Stretch {
        double value = 0, rate = 0, rest = 0; ///< of its coordinate, and where it would rest
        Wrench along;
        bool acts = true;
    };

    Stretch stretchOf(const Spring& spring, const Coordinates& q, const Coordinates& v) const noexcept;
    double forceOf(std::size_t spring, const Stretch& now) const noexcept;
    void addForce(const AppliedForce& force) noexcept;
    void addAir(double dt) noexcept;
    void addSprings(const Coordinates& q, const Coordinates& v) noexcept;
    void weighSprings(const DynamicState& state) noexcept;
    void closeLoops(DynamicState& state) noexcept;
    void findHeldForces(DynamicState& state, const Surroundings& around, bool early) noexcept;
    void advance(DynamicState& state, Surroundings around, int finest) noexcept;
    bool rungeKutta(DynamicState& state, const Surroundings& around, double dt, int finest,
                    bool whole) noexcept;
    void takeBack(DynamicState& state, double dt) noexcept;
    void normalise(Coordinates& q) const noexcept;
    void ratesOf(const Coordinates& q, const Coordinates& v, Coordinates& rate) const noexcept;

    std::shared_ptr<const Mechanism> mechanism_;
    Articulation articulation_;
    Loops loops_;
    Rows rows_;
    Coordinates along_; ///< forces along the coordinates that are held during a step
    Coordinates springs_;
    std::array<Coordinates, 4> a_, qRate_, v_;
    Coordinates q_, free_;
    DynamicState before_, looked_;
    std::uint64_t stoodStill_ = 0;
    std::vector<double> springInertia_; ///< of springs in accelerations; 1 for the others
    bool weighs_ = false;               ///< there is one in accelerations
};

} // namespace tactum
