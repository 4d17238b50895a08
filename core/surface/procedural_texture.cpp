#include "core/surface/procedural_texture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tactum {
namespace {

using Eigen::Vector2d;
constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kFadingOctaves = 3;
constexpr double kWhole = 8; ///< 2 to its power

double sinc(double x) noexcept {
    return std::abs(x) < 1e-9 ? 1 : std::sin(std::numbers::pi * x) / (std::numbers::pi * x);
}

/// Fourier transform of a raised cosine of unit area and width 1, at a frequency.
double raisedCosineSpectrum(double frequency) noexcept {
    const double rest = 1 - frequency * frequency;
    return std::abs(rest) < 1e-9 ? 0.5 : sinc(frequency) / rest;
}

/// Of a wave so many times as long as the smallest feature: smoothly from nothing to all.
double keptOf(double ratio) noexcept {
    if (!(ratio > 1)) return 0;
    if (ratio >= kWhole) return 1;
    double octaves = 0;
    for (; ratio >= 2; ratio /= 2)
        ++octaves;
    // log2 within 0.008: a parabola for each octave, with one slope where two of them meet
    const double x = (octaves + (ratio - 1) * (5 - ratio) * (1.0 / 3)) * (1 / kFadingOctaves);
    return x * x * (3 - 2 * x);
}

struct WaveSample {
    double value, slope; ///< slope per repeat
};

/// The wave at x repeats, `perMetre` repeats to a metre; harmonics by the recurrence of Chebyshev.
WaveSample sampleWave(const WaveShape& wave, double x, double perMetre, double smallestFeature) noexcept {
    const double angle = kTurn * repeatPart(x), c1 = std::cos(angle), s1 = std::sin(angle);
    WaveSample sum{wave.mean, 0};
    double c = c1, s = s1;
    for (int n = 1; n <= wave.harmonics; ++n) {
        const double part = kept(1 / (n * perMetre), smallestFeature);
        if (part == 0) break; // and so are all shorter ones
        const double amplitude = part * wave.amplitude[std::size_t(n - 1)];
        sum.value += amplitude * c;
        sum.slope -= kTurn * n * amplitude * s;
        const double next = c * c1 - s * s1;
        s = s * c1 + c * s1;
        c = next;
    }
    return sum;
}

/// A product of two sines of whole numbers of turns a repeat, scaled by what the band limit keeps of it.
FlatSample sineProduct(double amplitude, const Vector2d& turns, const FlatPoint& point,
                       double smallestFeature) noexcept {
    // Its two waves run along the sum and the difference of the directions.
    const Vec3 u = turns.x() * point.perMetre.row(0).transpose(),
               v = turns.y() * point.perMetre.row(1).transpose();
    const double a = amplitude * kept(1 / std::max((u + v).norm(), (u - v).norm()), smallestFeature);
    const Vector2d angle =
        kTurn * Vector2d(turns.x() * repeatPart(point.at.x()), turns.y() * repeatPart(point.at.y()));
    const double sx = std::sin(angle.x()), sy = std::sin(angle.y());
    return {a * sx * sy,
            kTurn * a * Vector2d(turns.x() * std::cos(angle.x()) * sy, turns.y() * sx * std::cos(angle.y()))};
}

// Four numbers at once, as the compiler has them for every processor: of the corners of a lattice cell, or a
// value and its derivatives by x and y.
using Bits4 [[gnu::vector_size(16)]] = std::uint32_t;
using Double4 [[gnu::vector_size(32)]] = double;

/// Which of 16 unit vectors, evenly spread, stands at each corner of a cell, by the bits of the corners.
/// Source: the finaliser of MurmurHash3.
[[gnu::always_inline]] inline Bits4 mixedBits(Bits4 h) noexcept {
    h = (h ^ (h >> 16)) * 0x85EBCA6Bu;
    h = (h ^ (h >> 13)) * 0xC2B2AE35u;
    return (h ^ (h >> 16)) & 15u;
}
constexpr double kA = 0.9238795325112867, kB = 0.7071067811865476, kC = 0.3826834323650898;
constexpr std::array<std::array<double, 2>, 16> kGradients{{{1, 0},
                                                            {kA, kC},
                                                            {kB, kB},
                                                            {kC, kA},
                                                            {0, 1},
                                                            {-kC, kA},
                                                            {-kB, kB},
                                                            {-kA, kC},
                                                            {-1, 0},
                                                            {-kA, -kC},
                                                            {-kB, -kB},
                                                            {-kC, -kA},
                                                            {0, -1},
                                                            {kC, -kA},
                                                            {kB, -kB},
                                                            {kA, -kC}}};

struct Fade {
    double value, slope;
    explicit Fade(double t) noexcept
        : value(t * t * t * (t * (6 * t - 15) + 10)), slope(30 * t * t * (t - 1) * (t - 1)) {}
};

/// The cell that repeatPart() is a part of.
[[gnu::always_inline]] inline std::uint32_t wholeRepeats(double x) noexcept {
    const auto whole = std::int64_t(x);
    return std::uint32_t(whole - (x < double(whole)));
}

/// Gradient noise of one octave, from about -1 to 1. Source: Perlin, Improving Noise (2002).
[[gnu::always_inline]] inline FlatSample latticeNoise(double u, double v, std::uint32_t seed) noexcept {
    constexpr std::uint32_t kX = 0x9E3779B1u, kY = 0x85EBCA77u, kSeed = 0xC2B2AE3Du;
    const double x = repeatPart(u), y = repeatPart(v);
    const std::uint32_t left = wholeRepeats(u) * kX, right = left + kX;
    const std::uint32_t below = wholeRepeats(v) * kY + seed * kSeed, above = below + kY;
    const Bits4 corner = mixedBits(Bits4{left, right, left, right} ^ Bits4{below, below, above, above});
    const auto &g00 = kGradients[corner[0]], &g10 = kGradients[corner[1]], &g01 = kGradients[corner[2]],
               &g11 = kGradients[corner[3]];
    // of each corner: its plane's height here, and how it rises along x and y
    const Double4 x0{x, 1, 0, 0}, x1{x - 1, 1, 0, 0}, y0{y, 0, 1, 0}, y1{y - 1, 0, 1, 0};
    const Double4 n00 = g00[0] * x0 + g00[1] * y0, n10 = g10[0] * x1 + g10[1] * y0,
                  n01 = g01[0] * x0 + g01[1] * y1, n11 = g11[0] * x1 + g11[1] * y1;
    const Fade fx(x), fy(y);
    const Double4 alongLower = n10 - n00, alongUpper = n11 - n01;
    const Double4 lower = n00 + fx.value * alongLower, up = (n01 + fx.value * alongUpper) - lower;
    const Double4 sum = lower + fy.value * up;
    const double byX = fx.slope * (alongLower[0] + fy.value * (alongUpper[0] - alongLower[0]));
    constexpr double kScale = std::numbers::sqrt2;
    return {kScale * sum[0], {kScale * (sum[1] + byX), kScale * (sum[2] + fy.slope * up[0])}};
}

/// How many repeats a metre has in the direction in which it has most.
double densestOf(const FlatPoint& point) noexcept {
    const Eigen::Matrix2d square = point.perMetre * point.perMetre.transpose();
    const double difference = 0.5 * (square(0, 0) - square(1, 1)), mixed = square(0, 1);
    return std::sqrt(0.5 * square.trace() + std::sqrt(difference * difference + mixed * mixed));
}

} // namespace

WaveShape waveShape(double fill, double softness) noexcept {
    WaveShape wave{fill, 0, {}};
    double highest = fill, lowest = fill; // in the middle of the raised part and of the other one
    for (int n = 1; n <= WaveShape::kHarmonics; ++n) {
        const double amplitude = 2 * fill * sinc(n * fill) * raisedCosineSpectrum(n * softness);
        wave.amplitude[std::size_t(n - 1)] = amplitude;
        if (std::abs(amplitude) > 1e-6) wave.harmonics = n;
        highest += amplitude;
        lowest += n % 2 == 0 ? amplitude : -amplitude;
    }
    const double scale = 1 / (highest - lowest);
    wave.mean = scale * (wave.mean - lowest);
    for (double& amplitude : wave.amplitude)
        amplitude *= scale;
    return wave;
}

double kept(double wavelength, double smallestFeature) noexcept {
    return smallestFeature > 0 ? keptOf(wavelength / smallestFeature) : 1;
}

FlatSample grooves(const WaveShape& wave, const FlatPoint& point, double smallestFeature) noexcept {
    const WaveSample u = sampleWave(wave, point.at.x(), point.perMetre.row(0).norm(), smallestFeature);
    return {u.value, {u.slope, 0}};
}

FlatSample dots(const WaveShape& wave, const FlatPoint& point, double smallestFeature) noexcept {
    // A product of waves has diagonal ones, shorter by up to the square root of two.
    const double limit = std::numbers::sqrt2 * smallestFeature;
    const WaveSample u = sampleWave(wave, point.at.x(), point.perMetre.row(0).norm(), limit);
    const WaveSample v = sampleWave(wave, point.at.y(), point.perMetre.row(1).norm(), limit);
    return {u.value * v.value, {u.slope * v.value, u.value * v.slope}};
}

// Threads have the profile sin^2 across; which one is on top goes with sin X sin Y. Multiplied out these are
// the waves 1/2 - (cos 2X + cos 2Y) / 4 + (sin X sin 3Y - sin 3X sin Y) / 8, with X = 2 pi u, Y = 2 pi v.
FlatSample weave(const FlatPoint& point, double smallestFeature) noexcept {
    static constexpr WaveShape kThreads{0, 2, {0, -0.25}};
    const WaveSample u = sampleWave(kThreads, point.at.x(), point.perMetre.row(0).norm(), smallestFeature);
    const WaveSample v = sampleWave(kThreads, point.at.y(), point.perMetre.row(1).norm(), smallestFeature);
    const FlatSample over = sineProduct(0.125, {1, 3}, point, smallestFeature),
                     under = sineProduct(0.125, {3, 1}, point, smallestFeature);
    return {0.5 + u.value + v.value + over.value - under.value,
            Vector2d(u.slope, v.slope) + over.slope - under.slope};
}

// A third of a textured step goes here (docs/performance.md).
[[gnu::target_clones("avx2", "default")]] FlatSample
noise(int octaves, std::uint32_t seed, const FlatPoint& point, double smallestFeature) noexcept {
    double ratio = smallestFeature > 0 ? 1 / (densestOf(point) * smallestFeature) : kWhole * (1 << octaves);
    FlatSample sum{0.5, Vector2d::Zero()};
    double height = 0.5 / (2 - 2 / double(1 << octaves)); // all octaves together reach from 0 to 1
    double cells = 1;
    for (int i = 0; i < octaves; ++i, cells *= 2, height /= 2, ratio /= 2) {
        const double amplitude = height * keptOf(ratio);
        if (amplitude == 0) break; // and so are all finer ones
        const FlatSample octave =
            latticeNoise(cells * point.at.x(), cells * point.at.y(), seed + std::uint32_t(i));
        sum.value += amplitude * octave.value;
        sum.slope += amplitude * cells * octave.slope;
    }
    return sum;
}

} // namespace tactum
