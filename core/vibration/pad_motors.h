// What of a touch the two motors of a gamepad can play, as it is felt.
#pragma once

#include "core/vibration/second_order.h"

namespace tactum {

/// Of a gamepad, 0 to 1: the heavy motor, which shakes slowly, and the light one, which shakes fast.
struct MotorStrengths {
    double low = 0, high = 0;

    bool operator==(const MotorStrengths&) const = default;
};

/// The vibration of a force (kSlowestVibration and faster) in two bands, each as strong as a sine of the same
/// power, of all three axes: a hand tells no directions apart there, and DFT321 keeps that power too
/// (vibrationOf()). What touches anew is a pulse besides: for kPulse both motors are as strong as a sine with
/// the largest force of the contact so far.
///
/// The bands meet at 100 Hz, which is a choice: makers say which motor is the slow one, and no figure. The
/// skin has one channel for what is fast, the Pacinian, best near 250 Hz, and others for what is slow
/// (Bolanowski and others, Four channels mediate the mechanical aspects of touch, J. Acoust. Soc. Am. 84,
/// 1988).
///
/// An eccentric mass pushes with m r w^2, and its speed w follows what a motor is told: so that is the root
/// of the force. Full strength is 1 N times the person's strength. Thread: any, one.
class PadMotors {
public:
    static constexpr double kSplit = 100;               ///< Hz
    static constexpr double kPulse = 0.05;              ///< s
    static constexpr double kApart = 0.05;              ///< s without a touch, after which one begins anew
    static constexpr double kRelease = 0.02;            ///< s without a touch, after which nothing vibrates
    static constexpr double kLowestRate = 4 * kSplit;   ///< Hz
    static constexpr double kHighestRate = 1000 * 1000; ///< Hz

    /// Of the ticks, in Hz; brought into the range above.
    explicit PadMotors(double rate = 1000);

    /// force in N; what is not finite is taken for what was before it.
    void tick(const Vec3& force, bool touching);
    /// Nothing vibrates. The force of the next tick is taken for one that has been there for ever, so that
    /// what is touched already is no impact; so at first, too.
    void rest();
    /// strength: 1 lets 1 N turn a motor with all it has, 2 half a newton.
    MotorStrengths strengths(double strength) const;

private:
    void settle(const Vec3& force);

    double tick_;   ///< s
    double follow_; ///< part of a tick's power that counts
    SecondOrder shaking_, low_, high_;
    double lowPower_ = 0, highPower_ = 0; ///< N^2, of the last moments
    double untouched_ = 0;                ///< s
    double pulse_ = 0;                    ///< s that are left of it
    double impact_ = 0;                   ///< N
    Vec3 last_ = Vec3::Zero();
    bool begun_ = false;
};

} // namespace tactum
