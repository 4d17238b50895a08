// One step in time of bodies and joints: smooth forces by Runge and Kutta's fourth order, what is not smooth
// by impulses.
#pragma once

#include <array>
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

/// A force on the material point that is now at `at`, constant in the world.
struct AppliedForce {
    Place at;
    Vec3 force_W = Vec3::Zero(); ///< N
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
inline constexpr double kLongestStep = 5e-3;

/// Thread: one at a time; step() real time, without allocation.
class Dynamics {
public:
    explicit Dynamics(std::shared_ptr<const Mechanism> mechanism);

    const Mechanism& mechanism() const noexcept { return *mechanism_; }
    DynamicState startState() const;

    /// Goes on by dt > 0. Deterministic: the same state and forces give the same bits.
    void step(DynamicState& state, const Vec3& gravity, std::span<const AppliedForce> forces,
              double dt) noexcept;

    /// Of each body of the mechanism, in its order.
    void describe(const DynamicState& state, const Vec3& gravity, std::span<BodyState> bodies) noexcept;
    /// What the springs hold: J. Of dampers and motors nothing.
    double springEnergy(const DynamicState& state) noexcept;
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
    void addSprings(const Coordinates& q, const Coordinates& v, double dt) noexcept;
    void weighSprings(const DynamicState& state) noexcept;
    void findHeldForces(DynamicState& state, const Surroundings& around, bool early) noexcept;
    void advance(DynamicState& state, Surroundings around) noexcept;
    void rungeKutta(DynamicState& state, const Surroundings& around, double dt) noexcept;
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
    DynamicState before_;
    std::vector<double> springInertia_; ///< of springs in accelerations; 1 for the others
    bool weighs_ = false;               ///< there is one in accelerations
};

} // namespace tactum
