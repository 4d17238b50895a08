// A device in a hand, axis by axis, integrated in small steps with its exact energy balance.
#pragma once

#include <array>

#include "core/base/vec.h"
#include "tests/physics/profiles.h"

namespace tactum::test {

/// One axis: m x" = F_a - b x' - f_c sgn(x') - F_grip, the amplifier lags F_a' = (F_cmd - F_a) / tau.
class PlantAxis {
public:
    PlantAxis() = default;
    PlantAxis(const PlantProfile& device, const HandProfile& hand);

    void place(double position, double velocity = 0);
    /// `command` in N, `voluntary`: the force of the person's muscles in N.
    void advance(double command, double voluntary, double dt);

    double x = 0, v = 0;         ///< of the device: m, m/s
    double handX = 0, handV = 0; ///< of the hand
    double goal = 0;             ///< m, where the arm's spring rests
    double force = 0;            ///< N, of the amplifier now
    /// J: what the loop gave, net of the device's own damping and friction. It is exactly what went into the
    /// hand and into motion.
    double given = 0;
    double lost = 0; ///< J, in the device

private:
    /// What depends on the length of a step alone: the steps of a tick are as long as each other.
    struct Step {
        double dt = 0;        ///< s
        double amplifier = 1; ///< part of the way from its force to the command
        double keeps = 1;     ///< of the velocity, after the device's damping
        double mobility = 0;  ///< s/kg, velocity for a push
        double brake = 0;     ///< m/s, that dry friction takes at most
    };
    Step stepOf(double dt) const;
    void moveHand(double voluntary, double dt);

    PlantProfile device_;
    HandProfile hand_;
    double mass_ = 1;
    Step step_;
};

/// Three axes that do not know of each other; frame D. `axes` = 1: only the third one moves.
class Plant {
public:
    Plant(const PlantProfile& device, const HandProfile& hand, int axes = 3);

    void place(const Vec3& position, const Vec3& velocity = Vec3::Zero());
    void advance(const Vec3& command, double dt);

    Vec3 position() const { return {axis[0].x, axis[1].x, axis[2].x}; }
    Vec3 velocity() const { return {axis[0].v, axis[1].v, axis[2].v}; }
    Vec3 actuated() const { return {axis[0].force, axis[1].force, axis[2].force}; }
    double given() const { return axis[0].given + axis[1].given + axis[2].given; }
    void setGoal(const Vec3& goal);

    std::array<PlantAxis, 3> axis;
    Vec3 voluntary = Vec3::Zero(); ///< N, of the person's muscles

private:
    int first_;
};

} // namespace tactum::test
