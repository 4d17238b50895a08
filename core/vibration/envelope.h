// How strong and how fast a vibration is from moment to moment: what parametric actuators are told.
#pragma once

#include <vector>

#include "core/vibration/vibration.h"

namespace tactum {

struct EnvelopePoint {
    double t = 0;         ///< s since the vibration began
    double amplitude = 0; ///< N of the sine that would have the same power
    double frequency =
        0; ///< Hz of the sine that would change as fast; where nothing vibrates, that of the point before
};

inline constexpr double kEnvelopeStep = 0.01; ///< s between points

/// By a window of 40 ms around each point, with soft ends. The frequency is the root of the power of the
/// signal's change over its own.
std::vector<EnvelopePoint> envelopeOf(const Vibration& vibration);

} // namespace tactum
