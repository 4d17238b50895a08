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

/// Of a wave so many times as long as the smallest feature what is kept of it: smoothly from nothing to all.
/// Of one number or of four at once, which no processor takes by value.
template <class T> [[gnu::always_inline]] inline void findKept(const T& ratio, T& kept) noexcept {
    T octaves{}, rest = ratio; // below kWhole two halvings at most
    for (int i = 0; i < 2; ++i) {
        octaves = rest >= 2 ? octaves + 1 : octaves;
        rest = rest >= 2 ? 0.5 * rest : rest;
    }
    // log2 within 0.008: a parabola for each octave, with one slope where two of them meet
    const T x = (octaves + (rest - 1) * (5 - rest) * (1.0 / 3)) * (1 / kFadingOctaves);
    const T part = x * x * (3 - 2 * x), all = T{} + 1;
    kept = ratio >= kWhole ? all : ratio > 1 ? part : T{};
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

// Four octaves of noise at once, as the compiler has numbers for every processor.
using Bits4 [[gnu::vector_size(16)]] = std::uint32_t;
using Int4 [[gnu::vector_size(16)]] = std::int32_t;
using Double2 [[gnu::vector_size(16)]] = double;
using Double4 [[gnu::vector_size(32)]] = double;

constexpr int kLanes = 4;
constexpr Double4 kCells{1, 2, 4, 8}; ///< each octave has twice as many to a repeat

/// Which of 16 unit vectors, evenly spread, stands at a corner of a cell, by the bits of the corner.
/// Source: the finaliser of MurmurHash3.
[[gnu::always_inline]] inline Bits4 mixedBits(Bits4 h) noexcept {
    h = (h ^ (h >> 16)) * 0x85EBCA6Bu;
    h = (h ^ (h >> 13)) * 0xC2B2AE35u;
    return (h ^ (h >> 16)) & 15u;
}
constexpr double kA = 0.9238795325112867, kB = 0.7071067811865476, kC = 0.3826834323650898;
constexpr std::array<Double2, 16> kGradients{{{1, 0},
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
    Double4 value, slope;
    [[gnu::always_inline]] explicit Fade(const Double4& t) noexcept
        : value(t * t * t * (t * (6 * t - 15) + 10)), slope(30 * t * t * (t - 1) * (t - 1)) {}
};

/// The cell that repeatPart() is a part of.
[[gnu::always_inline]] inline std::uint32_t wholeRepeats(double x) noexcept {
    const auto whole = std::int64_t(x);
    return std::uint32_t(whole - (x < double(whole)));
}

/// In which cell of each octave a coordinate lies, and where in it.
struct Cells {
    Bits4 number;
    Double4 part;
    [[gnu::always_inline]] Cells(double x, std::uint32_t first) noexcept {
        const Double4 scaled = repeatPart(x) * double(first) * kCells;
        const Int4 inner = __builtin_convertvector(scaled, Int4);
        number = wholeRepeats(x) * first * Bits4{1, 2, 4, 8} + Bits4(inner);
        part = scaled - __builtin_convertvector(inner, Double4);
    }
};

/// A value and how it rises along x and y, of four octaves.
struct Lattice {
    Double4 value, x, y;
};

/// The plane that stands at a corner, seen from (x, y) beside it.
[[gnu::always_inline]] inline Lattice cornerPlane(Bits4 bits, const Double4& x, const Double4& y) noexcept {
    const Bits4 which = mixedBits(bits);
    const Double4 even = __builtin_shufflevector(kGradients[which[0]], kGradients[which[2]], 0, 1, 2, 3),
                  odd = __builtin_shufflevector(kGradients[which[1]], kGradients[which[3]], 0, 1, 2, 3);
    const Double4 gx = __builtin_shufflevector(even, odd, 0, 4, 2, 6),
                  gy = __builtin_shufflevector(even, odd, 1, 5, 3, 7);
    return {gx * x + gy * y, gx, gy};
}

[[gnu::always_inline]] inline double sumOf(const Double4& x) noexcept {
    return (x[0] + x[2]) + (x[1] + x[3]);
}

[[gnu::always_inline]] inline Lattice mixed(const Lattice& a, const Lattice& b, const Double4& t) noexcept {
    return {a.value + t * (b.value - a.value), a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

/// Gradient noise, each octave from about -1 to 1 over cells of width 1. Source: Perlin, Improving Noise
/// (2002).
[[gnu::always_inline]] inline Lattice latticeNoise(const Cells& u, const Cells& v, Bits4 seed) noexcept {
    constexpr std::uint32_t kX = 0x9E3779B1u, kY = 0x85EBCA77u, kSeed = 0xC2B2AE3Du;
    const Bits4 left = u.number * kX, right = left + kX, below = v.number * kY + seed * kSeed,
                above = below + kY;
    const Double4 x = u.part, y = v.part;
    const Lattice n00 = cornerPlane(left ^ below, x, y), n10 = cornerPlane(right ^ below, x - 1, y),
                  n01 = cornerPlane(left ^ above, x, y - 1), n11 = cornerPlane(right ^ above, x - 1, y - 1);
    const Fade fx(x), fy(y);
    const Lattice lower = mixed(n00, n10, fx.value), upper = mixed(n01, n11, fx.value);
    const Lattice sum = mixed(lower, upper, fy.value);
    const Double4 alongLower = n10.value - n00.value, alongUpper = n11.value - n01.value;
    const Double4 byX = fx.slope * (alongLower + fy.value * (alongUpper - alongLower));
    constexpr double kScale = std::numbers::sqrt2;
    return {kScale * sum.value, kScale * (sum.x + byX),
            kScale * (sum.y + fy.slope * (upper.value - lower.value))};
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
    double part = 1;
    if (smallestFeature > 0) findKept(wavelength / smallestFeature, part);
    return part;
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

// Much of a textured step goes here (docs/performance.md).
#ifndef __SANITIZE_THREAD__ // which has not begun yet when the loader chooses one of them
[[gnu::target_clones("avx2", "default")]]
#endif
FlatSample
noise(int octaves, std::uint32_t seed, const FlatPoint& point, double smallestFeature) noexcept {
    const double ratio =
        smallestFeature > 0 ? 1 / (densestOf(point) * smallestFeature) : kWhole * (1 << octaves);
    const auto cellsOfLast = double(1 << octaves) / 2;
    const double height = 0.5 / (2 - 1 / cellsOfLast); // all octaves together reach from 0 to 1
    FlatSample sum{0.5, Vector2d::Zero()};
    for (int first = 0; first < octaves; first += kLanes) {
        const Double4 cells = double(1 << first) * kCells;
        Double4 part;
        findKept<Double4>(ratio / cells, part);
        if (part[0] == 0) break; // and so are all finer ones
        const Lattice found = latticeNoise(Cells(point.at.x(), 1u << first), Cells(point.at.y(), 1u << first),
                                           seed + std::uint32_t(first) + Bits4{0, 1, 2, 3});
        const Double4 slope = cells <= cellsOfLast ? height * part : Double4{}, amplitude = slope / cells;
        sum.value += sumOf(amplitude * found.value);
        sum.slope += Vector2d(sumOf(slope * found.x), sumOf(slope * found.y));
    }
    return sum;
}

} // namespace tactum
