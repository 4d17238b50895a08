#include "core/surface/image_sample.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tactum {
namespace {

using Eigen::Vector2d;

FlatSample operator+(const FlatSample& a, const FlatSample& b) noexcept {
    return {a.value + b.value, a.slope + b.slope};
}
FlatSample operator*(double s, const FlatSample& a) noexcept {
    return {s * a.value, s * a.slope};
}

/// The two neighbouring texels of a row, repeating, and how far between their centres the place is.
struct Between {
    int low, high;
    double part;
};

/// `place`: from 0 to 1.
Between between(double place, int size) noexcept {
    const double x = place * size - 0.5;
    if (x < 0) return {size - 1, 0, x + 1};
    const int low = int(x);
    return {low < size ? low : size - 1, low + 1 < size ? low + 1 : 0, x - low};
}

FlatSample bilinear(const TextureImage& image, const TextureImage::Level& level,
                    const Vector2d& at) noexcept {
    const Between x = between(at.x(), level.width), y = between(at.y(), level.height);
    const std::uint16_t *lowRow = image.row(level, y.low), *highRow = image.row(level, y.high);
    const double a = lowRow[x.low], b = lowRow[x.high], c = highRow[x.low], d = highRow[x.high];
    const double lower = a + x.part * (b - a), upper = c + x.part * (d - c);
    constexpr double kScale = 1 / 65535.0;
    const double alongX = (b - a) + y.part * ((d - c) - (b - a));
    return {kScale * (lower + y.part * (upper - lower)),
            Vector2d(kScale * level.width * alongX, kScale * level.height * (upper - lower))};
}

FlatSample trilinear(const TextureImage& image, double detail, const Vector2d& repeats) noexcept {
    const Vector2d at(repeatPart(repeats.x()), repeatPart(repeats.y()));
    const int finer = int(detail);
    const double part = detail - finer;
    const FlatSample fine = bilinear(image, image.level(finer), at);
    if (part == 0) return fine;
    return (1 - part) * fine + part * bilinear(image, image.level(finer + 1), at);
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
    const double width = 2 * std::sqrt(std::max(longest * longest - across * across, 0.0));
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
