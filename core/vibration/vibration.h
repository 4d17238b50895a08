// What of a touch an actuator without a motor to push can play: a phone, a gamepad, a pen with a voice coil.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/haptics/replay.h"

namespace tactum {

/// A signal of one axis. What pushes slower than a hand shakes is not in it.
struct Vibration {
    double rate = 8000;        ///< samples a second
    std::vector<double> force; ///< N
};

/// Hz. Slower is a push, and nothing that an actuator without a motor could give: half of the amplitude is
/// left here, a seventeenth an octave below.
inline constexpr double kSlowestVibration = 20;
/// s; longer strokes are refused.
inline constexpr double kLongestVibration = 600;

/// The three axes of the force made one, by DFT321: as much power at each frequency as the three have
/// together, in the phase of their sum (Landin, Romano, McMahan, Kuchenbecker: Dimensional Reduction of
/// High-Frequency Accelerations for Haptic Rendering, EuroHaptics 2010), since a hand tells no directions
/// apart there. Of the path's own time, whatever it begins with; nothing is in it that is faster than half
/// the path's rate. Input error: fewer than two rows, or a stroke that is too long.
Result<Vibration> vibrationOf(const TouchTrace& rows);

/// The largest of either sign; N.
double peakOf(const Vibration& vibration);

} // namespace tactum
