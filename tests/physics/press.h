// A hand that presses a wall or hits it, and whether the wall then holds still.
#pragma once

#include "tests/physics/servo.h"

namespace tactum::test {

/// How the wall is met. SI.
struct Press {
    double force = 1;   ///< N, of the muscles
    double impact = 0;  ///< m/s, with which the finger arrives; 0: it begins on the wall
    double damping = 0; ///< N s/m, of the wall
};

inline constexpr std::array kPresses{Press{0.3, 0}, Press{1, 0}, Press{2.5, 0}, Press{1, 0.05},
                                     Press{1, 0.3}};

struct Rest {
    double motion = 0;    ///< m, peak to peak, as it really was, in the last half second
    double force = 0;     ///< N, peak to peak, commanded, in the last half second
    double steady = 0;    ///< N, mean command of the last half second
    double peak = 0;      ///< N, largest command of the whole run
    double given = 0;     ///< J, largest that the loop had given net of the device's losses
    bool lost = false;    ///< contact, after the first second
    double stiffness = 0; ///< N/m, rendered at the end

    /// T4's bound: two counts, and the force of two counts.
    bool still(double resolution) const {
        return motion <= 2 * resolution && force <= 2 * stiffness * resolution * (1 + 1e-9) && !lost;
    }
};

/// The wall z = 0 as a plain spring, without anything that guards it.
Rest pressPlain(const Bench& bench, const Press& press, double stiffness, double seconds = 3);
/// As the product's servo renders it. `prepare` may change the servo before it begins.
Rest pressServo(const Bench& bench, const Press& press, double stiffness, double seconds = 3,
                const std::function<void(Servo&)>& prepare = {});

} // namespace tactum::test
