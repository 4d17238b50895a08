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

/// A well-mixed number of a lattice point. Source: the finaliser of MurmurHash3.
std::uint32_t hashOf(std::uint32_t x, std::uint32_t y, std::uint32_t seed) noexcept {
    std::uint32_t h = x * 0x9E3779B1u ^ (y * 0x85EBCA77u + seed * 0xC2B2AE3Du);
    h = (h ^ (h >> 16)) * 0x85EBCA6Bu;
    h = (h ^ (h >> 13)) * 0xC2B2AE35u;
    return h ^ (h >> 16);
}

/// One of 16 unit vectors, evenly spread.
Vector2d latticeGradient(std::uint32_t x, std::uint32_t y, std::uint32_t seed) noexcept {
    constexpr double a = 0.9238795325112867, b = 0.7071067811865476, c = 0.3826834323650898;
    static constexpr std::array<double, 20> kCosine{1,  a,  b, c, 0, -c, -b, -a, -1, -a,
                                                    -b, -c, 0, c, b, a,  1,  a,  b,  c};
    const std::uint32_t i = hashOf(x, y, seed) & 15u;
    return {kCosine[i], kCosine[i < 4 ? i + 12 : i - 4]}; // sin a = cos(a - 90 degrees)
}

struct Fade {
    double value, slope;
    explicit Fade(double t) noexcept
        : value(t * t * t * (t * (6 * t - 15) + 10)), slope(30 * t * t * (t - 1) * (t - 1)) {}
};

/// Gradient noise of one octave, from about -1 to 1. Source: Perlin, Improving Noise (2002).
FlatSample latticeNoise(const Vector2d& at, std::uint32_t seed) noexcept {
    const Vector2d t(repeatPart(at.x()), repeatPart(at.y()));
    const auto lattice = [](double cell) {
        return std::uint32_t(std::int64_t(cell < 0 ? cell - 0.5 : cell + 0.5));
    };
    const std::uint32_t x = lattice(at.x() - t.x()), y = lattice(at.y() - t.y());
    const Vector2d g00 = latticeGradient(x, y, seed), g10 = latticeGradient(x + 1, y, seed),
                   g01 = latticeGradient(x, y + 1, seed), g11 = latticeGradient(x + 1, y + 1, seed);
    const double n00 = g00.dot(t), n10 = g10.dot(t - Vector2d(1, 0)), n01 = g01.dot(t - Vector2d(0, 1)),
                 n11 = g11.dot(t - Vector2d(1, 1));
    const Fade fx(t.x()), fy(t.y());
    const double lower = n00 + fx.value * (n10 - n00), upper = n01 + fx.value * (n11 - n01);
    const Vector2d gLower = g00 + fx.value * (g10 - g00), gUpper = g01 + fx.value * (g11 - g01);
    const double byX = fx.slope * ((n10 - n00) + fy.value * ((n11 - n01) - (n10 - n00)));
    const Vector2d slope = gLower + fy.value * (gUpper - gLower) + Vector2d(byX, fy.slope * (upper - lower));
    return {std::numbers::sqrt2 * (lower + fy.value * (upper - lower)), std::numbers::sqrt2 * slope};
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
    if (!(smallestFeature > 0)) return 1;
    const double ratio = wavelength / smallestFeature;
    if (!(ratio > 1)) return 0;
    if (ratio >= kWhole) return 1; // most are: no logarithm for them
    const double x = std::log2(ratio) / kFadingOctaves;
    return x * x * (3 - 2 * x);
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

FlatSample noise(int octaves, std::uint32_t seed, const FlatPoint& point, double smallestFeature) noexcept {
    const double densest = smallestFeature > 0 ? densestOf(point) : 0;
    FlatSample sum{0.5, Vector2d::Zero()};
    double height = 0.5 / (2 - std::ldexp(1.0, 1 - octaves)); // all octaves together reach from 0 to 1
    double cells = 1;
    for (int i = 0; i < octaves; ++i, cells *= 2, height /= 2) {
        const double amplitude = height * kept(1 / (cells * densest), smallestFeature);
        if (amplitude == 0) break; // and so are all finer ones
        const FlatSample octave = latticeNoise(cells * point.at, seed + std::uint32_t(i));
        sum.value += amplitude * octave.value;
        sum.slope += amplitude * cells * octave.slope;
    }
    return sum;
}

} // namespace tactum
