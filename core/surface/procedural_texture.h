// Patterns from formulas: sums of waves and noise, with analytic slopes and a band limit of their own.
#pragma once

#include <array>
#include <cstdint>

#include "core/surface/texture_field.h"

namespace tactum {

/// One period of a raised and a low part with soft edges, from 0 to 1, as a Fourier series about the middle
/// of the raised part: value(x) = mean + sum of amplitude[n - 1] cos(2 pi n x).
struct WaveShape {
    static constexpr int kHarmonics = 16;
    double mean = 0;
    int harmonics = 0; ///< how many there are; the others are next to nothing
    std::array<double, kHarmonics> amplitude{};
};

/// `fill`: the raised part of the period. `softness`: width of an edge, part of a period; an edge is a raised
/// cosine, which 16 harmonics render within 1.5 % from a softness of 0.1 on. Where the edges leave no room
/// for a plain top or bottom the wave is stretched: its highest place is always 1 above its lowest.
WaveShape waveShape(double fill, double softness) noexcept;

/// What of a wave of this length (m) is kept: nothing up to `smallestFeature`, a quarter of twice its length,
/// all from eight times of it on.
double kept(double wavelength, double smallestFeature) noexcept;

// Values from 0 to 1. Thread: real time; a bounded number of operations each.

/// Ridges across u.
FlatSample grooves(const WaveShape& wave, const FlatPoint& point, double smallestFeature) noexcept;
/// One bump in each repeat.
FlatSample dots(const WaveShape& wave, const FlatPoint& point, double smallestFeature) noexcept;
/// Plain weave, two threads by two in each repeat.
FlatSample weave(const FlatPoint& point, double smallestFeature) noexcept;
/// Gradient noise (Perlin's, with a fade of fifth degree); its coarsest grain is one repeat.
FlatSample noise(int octaves, std::uint32_t seed, const FlatPoint& point, double smallestFeature) noexcept;

} // namespace tactum
