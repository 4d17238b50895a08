#include "core/surface/image_sample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace tactum {
namespace {

using Eigen::Vector2d;

/// Of the raised cosine, in features: it keeps of a wave about what the levels keep.
constexpr double kWidth = 2;

FlatSample operator+(const FlatSample& a, const FlatSample& b) noexcept {
    return {a.value + b.value, a.slope + b.slope};
}
FlatSample operator*(double s, const FlatSample& a) noexcept {
    return {s * a.value, s * a.slope};
}

constexpr int kTaps = 6;

/// How much each of six texels in a row counts, and how that changes per texel: cubics that go through every
/// texel, with a continuous slope, which of a wave of 8 texels is off by 0.7 % (root mean square) and of one
/// of 16 by 0.05 %. Source: Keys, Cubic convolution interpolation, IEEE Trans. ASSP 29 (1981), the kernel of
/// six points.
struct Weights {
    std::array<double, kTaps> value, slope;
    int first; ///< texel, may lie outside of the picture
};

/// `x`: the place in texels.
Weights weightsAt(double x) noexcept {
    const int low = int(std::floor(x - 0.5));
    const double t = x - 0.5 - low, t2 = t * t, t3 = t2 * t, u = 1 - t, u2 = u * u, u3 = u2 * u;
    // The kernel at t + 2, t + 1, t and, mirrored, at u, u + 1, u + 2: each as a polynomial of t or u.
    const auto far = [](double x1, double x2, double x3) { return (x3 - 2 * x2 + x1) / 12; };
    const auto farSlope = [](double x1, double x2) { return (3 * x2 - 4 * x1 + 1) / 12; };
    const auto middle = [](double x1, double x2, double x3) { return (-7 * x3 + 15 * x2 - 8 * x1) / 12; };
    const auto middleSlope = [](double x1, double x2) { return (-21 * x2 + 30 * x1 - 8) / 12; };
    const auto near = [](double x2, double x3) { return (4 * x3 - 7 * x2 + 3) / 3; };
    const auto nearSlope = [](double x1, double x2) { return (12 * x2 - 14 * x1) / 3; };
    return {
        {far(t, t2, t3), middle(t, t2, t3), near(t2, t3), near(u2, u3), middle(u, u2, u3), far(u, u2, u3)},
        {farSlope(t, t2), middleSlope(t, t2), nearSlope(t, t2), -nearSlope(u, u2), -middleSlope(u, u2),
         -farSlope(u, u2)},
        low - 2};
}

/// The six columns or rows, repeating.
std::array<int, kTaps> texelsOf(int first, int size) noexcept {
    std::array<int, kTaps> texels{};
    const bool inside = first >= 0 && first + kTaps <= size;
    for (int i = 0; i < kTaps; ++i)
        texels[std::size_t(i)] = inside ? first + i : ((first + i) % size + size) % size;
    return texels;
}

FlatSample smooth(const TextureImage& image, const TextureImage::Level& level, const Vector2d& at) noexcept {
    const Weights x = weightsAt(at.x() * level.width), y = weightsAt(at.y() * level.height);
    const std::array<int, kTaps> columns = texelsOf(x.first, level.width),
                                 rows = texelsOf(y.first, level.height);
    double value = 0, alongX = 0, alongY = 0;
    for (std::size_t j = 0; j < rows.size(); ++j) {
        double sum = 0, slope = 0;
        image.visitRow(level, rows[j], [&](const auto* row) {
            for (std::size_t i = 0; i < columns.size(); ++i) {
                const auto texel = double(row[columns[i]]);
                sum += x.value[i] * texel;
                slope += x.slope[i] * texel;
            }
        });
        value += y.value[j] * sum;
        alongX += y.value[j] * slope;
        alongY += y.slope[j] * sum;
    }
    constexpr double kScale = 1 / 65535.0;
    return {kScale * value, Vector2d(kScale * level.width * alongX, kScale * level.height * alongY)};
}

FlatSample trilinear(const TextureImage& image, double detail, const Vector2d& repeats) noexcept {
    const Vector2d at(repeatPart(repeats.x()), repeatPart(repeats.y()));
    const int finer = int(detail);
    const double part = detail - finer;
    const FlatSample fine = smooth(image, image.level(finer), at);
    if (part == 0) return fine;
    return (1 - part) * fine + part * smooth(image, image.level(finer + 1), at);
}

/// What is averaged for one sample.
struct Footprint {
    double detail = 0; ///< level, with its fraction
    int probes = 1;
    Vector2d axis = Vector2d::Zero(); ///< repeats: from the first place to the last one, about
};

/// The unit eigenvector of a symmetric matrix for its greater eigenvalue.
Vector2d longAxis(const Eigen::Matrix2d& square, double eigenvalue) noexcept {
    const Vector2d one(square(0, 1), eigenvalue - square(0, 0)),
        other(eigenvalue - square(1, 1), square(0, 1));
    return (one.squaredNorm() > other.squaredNorm() ? one : other).normalized();
}

Footprint footprintOf(const TextureImage& image, const FlatPoint& point, double smallestFeature) noexcept {
    Footprint footprint;
    if (!(smallestFeature > 0)) return footprint;
    const Vector2d size(image.width(), image.height());
    // Singular values of the texels per metre: those of a 2 x 3 matrix, from its square.
    const Eigen::Matrix<double, 2, 3> texels = size.asDiagonal() * point.perMetre;
    const Eigen::Matrix2d square = texels * texels.transpose();
    const double mean = 0.5 * square.trace(),
                 spread = std::hypot(0.5 * (square(0, 0) - square(1, 1)), square(0, 1));
    const double longest = smallestFeature * std::sqrt(mean + spread),
                 shortest = smallestFeature * std::sqrt(std::max(mean - spread, 0.0));
    if (!(longest < 1e9))
        return {double(image.levelCount() - 1), 1, Vector2d::Zero()};       // only the mean is left
    const double across = std::max({shortest, longest / kMaxStretch, 1.0}); // texels: what the level does
    footprint.detail = std::min(std::log2(across), double(image.levelCount() - 1));
    // What is missing along the long axis; widths of filters in a row add up by their squares.
    const double width = kWidth * std::sqrt(std::max(longest * longest - across * across, 0.0));
    if (width <= across) return footprint;
    // A texel of the level apart: then along a row of texels none counts twice and none is left out.
    footprint.probes = std::min(int(std::ceil(width / across)), kMaxProbes);
    footprint.axis = footprint.probes * across * longAxis(square, mean + spread).cwiseQuotient(size);
    return footprint;
}

} // namespace

FlatSample sampleImage(const TextureImage& image, const FlatPoint& point, double smallestFeature) noexcept {
    const Footprint footprint = footprintOf(image, point, smallestFeature);
    if (footprint.probes == 1) return trilinear(image, footprint.detail, point.at);
    FlatSample sum;
    for (int i = 0; i < footprint.probes; ++i) {
        const double along = (i + 0.5) / footprint.probes; // raised cosine: its weights sum to the probes
        const double weight = (1 - std::cos(2 * std::numbers::pi * along)) / footprint.probes;
        sum = sum + weight * trilinear(image, footprint.detail, point.at + (along - 0.5) * footprint.axis);
    }
    return sum;
}

} // namespace tactum
