// How warm the motors are, and what force they can still bear.
#pragma once

namespace tactum {

/// Of the heat that motors bear, from where the limit falls.
inline constexpr double kWarmMotors = 0.7;
/// s, in which motors take on or lose heat; of small desktop devices it lies between 30 and 60.
inline constexpr double kMotorTime = 40;

/// The heat of motors whose windings warm with the square of the force, tau h' = (F / F_continuous)^2 - h:
/// 1 is what they bear for ever. From seven tenths on the limit falls from the peak to the continuous force,
/// so that a press that never ends settles there without a step. SI. Thread: real time.
class MotorHeat {
public:
    MotorHeat(double maxForce, double continuousForce) noexcept;

    /// `force` in N, commanded during the last dt seconds.
    void add(double force, double dt) noexcept;
    /// Goes on from the heat that the same motors had `seconds` ago, without force since.
    void resume(double heat, double seconds) noexcept;
    double heat() const noexcept { return heat_; } ///< 0 cold, 1 as warm as it may be
    double limit() const noexcept;                 ///< N, at most maxForce

    /// All that it remembers, for the recorder (core/base/byte_archive.h).
    static void fields(auto& visit, auto& self) { visit(self.max_, self.continuous_, self.heat_); }

private:
    double max_, continuous_, heat_ = 0;
};

} // namespace tactum
