#include "core/presets/vibration_model.h"

#include <cmath>
#include <numbers>

#include "core/surface/procedural_texture.h"

namespace tactum {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kOctaves = 3; // a relief with detail, and still one coarsest grain

double square(double x) {
    return x * x;
}

/// |A|^2 on the unit circle. With P and Q the sum and the difference of the polynomial and its mirror image,
/// whose roots are the line spectral frequencies in turn, A = (P + Q) / 2, and the two are a quarter of a
/// turn apart everywhere. Source: Itakura (1975).
double powerOfPolynomial(const std::vector<double>& lsf, double angle) {
    double p = 1, q = 1;
    for (std::size_t i = 0; i < lsf.size(); ++i)
        (i % 2 == 0 ? p : q) *= square(2 * std::cos(angle) - 2 * std::cos(lsf[i]));
    if (lsf.size() % 2 == 0) { // roots at -1 and 1
        p *= square(2 * std::cos(angle / 2));
        q *= square(2 * std::sin(angle / 2));
    } else {
        q *= square(2 * std::sin(angle));
    }
    return (p + q) / 4;
}

} // namespace

double accelerationSpectrum(const VibrationModel& model, double sampleRate, double frequency) {
    return 2 * model.variance / sampleRate / powerOfPolynomial(model.lsf, 2 * kPi * frequency / sampleRate);
}

double ReliefFigures::wavelength() const {
    return 2 * kPi * height / slope;
}

ReliefFigures reliefOf(const VibrationModel& model, double sampleRate) {
    // Simpson's rule.
    constexpr int kSteps = 1 << 14;
    const double from = kSlowestVibration, step = (sampleRate / 2 - from) / kSteps;
    double height = 0, velocity = 0;
    for (int i = 0; i <= kSteps; ++i) {
        const double frequency = from + i * step, turn = square(2 * kPi * frequency);
        const double weight = (i == 0 || i == kSteps ? 1 : i % 2 == 1 ? 4 : 2) * step / 3;
        const double part = weight * accelerationSpectrum(model, sampleRate, frequency) / turn;
        velocity += part;
        height += part / turn;
    }
    return {std::sqrt(height), std::sqrt(velocity) / model.speed};
}

ReliefFigures noiseFigures(int octaves) {
    // Places that fall everywhere in the cells of every octave: multiples of two irrational numbers.
    constexpr int kPlaces = 40000;
    constexpr double kAlongU = 0.7548776662466927, kAlongV = 0.5698402909980532;
    FlatPoint point;
    point.perMetre(0, 0) = point.perMetre(1, 1) = 1;
    double sum = 0, squares = 0, slopes = 0;
    for (int i = 0; i < kPlaces; ++i) {
        point.at = {kAlongU * i, kAlongV * i};
        const FlatSample sample = noise(octaves, 0, point, 0);
        sum += sample.value;
        squares += square(sample.value);
        slopes += sample.slope.squaredNorm() / 2; // of the two directions
    }
    const double mean = sum / kPlaces;
    return {std::sqrt(squares / kPlaces - square(mean)), std::sqrt(slopes / kPlaces)};
}

TextureLayer noiseLike(const ReliefFigures& figures) {
    const ReliefFigures unit = noiseFigures(kOctaves);
    TextureLayer layer;
    layer.name = "relief";
    layer.pattern.octaves = kOctaves;
    layer.strength = kTextureHeight.clamped(figures.height / unit.height);
    layer.pattern.size = kTextureSize.clamped(figures.wavelength() / unit.wavelength());
    return layer;
}

} // namespace tactum
