// The vibration of a tool dragged over a surface, as an autoregressive process, and the relief that would
// cause it. docs/presets.md derives it.
#pragma once

#include <vector>

#include "core/surface/texture_layer.h"

namespace tactum {

/// The acceleration of a tool at one speed and one force, as Penn's haptic texture models describe it.
struct VibrationModel {
    std::vector<double> lsf; ///< line spectral frequencies, rising, between 0 and pi
    double variance = 0;     ///< of the white noise that drives it, (m/s^2)^2
    double speed = 0;        ///< m/s
    double force = 0;        ///< N
};

/// Power of the acceleration per hertz, of positive frequencies: (m/s^2)^2/Hz.
double accelerationSpectrum(const VibrationModel& model, double sampleRate, double frequency);

/// A random relief by two numbers that a line across it shows.
struct ReliefFigures {
    double height = 0; ///< m, root mean square
    double slope = 0;  ///< m/m, root mean square

    /// Mean distance at which such a line crosses its mean height upward, m. Source: Rice (1944).
    double wavelength() const;
};

/// Slower than this it is the hand that moves, not the texture. Hz
inline constexpr double kSlowestVibration = 20;

/// Of the relief that shakes a tool like this when its tip follows it: heights are accelerations divided by
/// (2 pi f)^2, lengths are speeds divided by frequencies.
ReliefFigures reliefOf(const VibrationModel& model, double sampleRate);

/// A layer of noise with these figures along its lines, but for the ranges of its parameters.
TextureLayer noiseLike(const ReliefFigures& figures);
/// Of our noise: a repeat of 1 m, 1 m high.
ReliefFigures noiseFigures(int octaves);

} // namespace tactum
