// The Falcon's arm in somebody's hand: a mass that a grip leads, and that the motors push. It knows the arm
// by formulas of its own, not by those of the driver.
#pragma once

#include <array>

#include "core/base/vec.h"

namespace tactum::test {

/// Angles of the legs in degrees with the grip at `p`, m from the middle of the base.
/// Not finite when the arm does not reach.
Vec3 legDegrees(const Vec3& p);

/// The force at the grip, N, of torques at the legs, N m: by the work that they do in small steps of the
/// grip.
Vec3 forceAtGrip(const Vec3& p, const Vec3& torques);

class FalconBody {
public:
    struct Hand {
        double mass = 0.15;     ///< kg, with the moving arm
        double stiffness = 300; ///< N/m, of the grip
        double damping = 10;    ///< N s/m
        double speed = 0.25;    ///< m/s, with which it goes where it wants to be
    };

    Hand hand;

    /// Where the hand wants the grip, from the middle of the base; the grip itself is put there at once.
    void put(const Vec3& p);
    void leadTo(const Vec3& p);
    /// All the way out, all the way in and to the middle, as a person homes it.
    void home() { homing_ = kStations; }
    /// So far on, with torques N m at the legs.
    void step(double dt, const Vec3& torques);

    const Vec3& position() const { return position_; } ///< from the middle of the base
    const Vec3& velocity() const { return velocity_; }
    Vec3 degrees() const { return legDegrees(position_); }
    bool arrived() const { return led_ == goal_ && homing_ == 0; }

private:
    static constexpr int kStations = 3;
    void lead(double dt);

    Vec3 position_{0, 0, 0.11}, velocity_ = Vec3::Zero();
    Vec3 goal_ = position_, led_ = position_; ///< `led_`: where the hand is on the way to its goal
    int homing_ = 0;                          ///< stations that it has before it
};

} // namespace tactum::test
