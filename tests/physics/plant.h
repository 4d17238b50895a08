// A device in a hand, axis by axis, integrated in small steps with its exact energy balance.
#pragma once

#include <Eigen/Core>

#include "core/base/vec.h"
#include "tests/physics/profiles.h"

namespace tactum::test {

/// A number for each axis of frame D, and one that stays zero: two at a time are worked out as one.
using Axes = Eigen::Array4d;

/// Three axes that do not know of each other: m x" = F_a - b x' - f_c sgn(x') - F_grip, the amplifier lags
/// F_a' = (F_cmd - F_a) / tau. `axes` = 1: only the third one moves.
class Plant {
public:
    Plant(const PlantProfile& device, const HandProfile& hand, int axes = 3);

    void place(const Vec3& position, const Vec3& velocity = Vec3::Zero());
    /// `command` in N.
    void advance(const Vec3& command, double dt);

    Vec3 position() const { return x.head<3>(); }
    Vec3 velocity() const { return v.head<3>(); }
    Vec3 actuated() const { return force.head<3>(); }
    /// J: what the loop gave, net of the device's own damping and friction. It is exactly what went into the
    /// hand and into motion.
    double given() const { return given_[0] + given_[1] + given_[2]; }
    void setGoal(const Vec3& at) { goal = lanes(at); }

    Vec3 voluntary = Vec3::Zero();                   ///< N, of the person's muscles
    Axes x = Axes::Zero(), v = Axes::Zero();         ///< of the device: m, m/s
    Axes handX = Axes::Zero(), handV = Axes::Zero(); ///< of the hand
    Axes goal = Axes::Zero();                        ///< m, where the arm's spring rests
    Axes force = Axes::Zero();                       ///< N, of the amplifiers now

private:
    /// What depends on the length of a step alone: the steps of a tick are as long as each other.
    struct Step {
        double dt = 0;                ///< s
        double amplifier = 1;         ///< part of the way from its force to the command
        double keeps = 1;             ///< of the velocity, after the device's damping
        Axes time = Axes::Zero();     ///< s, none for an axis that does not move
        Axes mobility = Axes::Zero(); ///< s/kg, velocity for a push
        Axes brake = Axes::Zero();    ///< m/s, that dry friction takes at most
    };
    Step stepOf(double dt) const;
    void moveHand(const Axes& muscles);
    static Axes lanes(const Vec3& each) { return {each[0], each[1], each[2], 0}; }

    PlantProfile device_;
    HandProfile hand_;
    Axes moves_;                ///< 1 or 0
    Axes given_ = Axes::Zero(); ///< J
    double mass_ = 1;
    Step step_;
};

} // namespace tactum::test
