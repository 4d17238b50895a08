#include "core/surface/painted_sample.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/surface/clough_tocher.h"
#include "core/surface/painted_slopes.h"
#include "core/surface/unrolled_place.h"

namespace tactum {
namespace {

/// And on a sliver without a plane, which has no slope.
Rise onSegment(const Triangle& triangle, const Vec3& values, const Vec3& weights, bool isSegment) noexcept {
    const Vec3 along = triangle.b - triangle.a;
    const double squared = along.squaredNorm();
    return {weights.dot(values),
            isSegment && squared > 0 ? Vec3((values[1] - values[0]) / squared * along) : Vec3::Zero()};
}

Vec3 valuesAt(const CompiledPattern& pattern, Index triangle) noexcept {
    const auto& corners = pattern.soup->triangles[triangle];
    return {(*pattern.painted)[corners[0]], (*pattern.painted)[corners[1]], (*pattern.painted)[corners[2]]};
}

/// No weight below zero.
Rise onTriangle(const CompiledPattern& pattern, Index index, const Triangle& triangle,
                const Vec3& weights) noexcept {
    const Vec3 values = valuesAt(pattern, index);
    const std::array<Vec3, 3> slopes = paintedSlopes(pattern, index);
    const Rise rise = CloughTocher(triangle, values, slopes, pattern.slopes->bulge(index)).at(weights);
    return rise.slope.allFinite() ? rise : Rise{weights.dot(values), linearSlope(triangle, values)};
}

/// Beside a triangle, too, where the surface goes on, and straight on where it ends.
Rise onSurface(const CompiledPattern& pattern, Index triangle, const Vec3& weights) noexcept {
    const UnrolledPlace place(*pattern.soup, *pattern.slopes->ground(), triangle, weights);
    const Vec3 inside = place.weights().cwiseMax(0) / place.weights().cwiseMax(0).sum(),
               beside = place.weights() - inside;
    const Triangle& t = place.corners();
    Rise rise = onTriangle(pattern, place.triangle(), t, inside);
    rise.value += rise.slope.dot(beside[0] * t.a + beside[1] * t.b + beside[2] * t.c);
    rise.slope = place.turnedBack(rise.slope);
    return rise;
}

/// What is averaged for one sample: places in a row, as far apart as mesh and not speed says, so that none
/// comes and goes with a weight when a finger gets faster.
struct Row {
    int places = 0;            ///< to either side
    double length = 0;         ///< of all of it, in places
    Vec3 apart = Vec3::Zero(); ///< weights of a triangle
};

/// How far places of the mesh are from one another at one of a triangle, along a unit vector, m.
double spacingAt(const CompiledPattern& pattern, Index triangle, const Vec3& weights,
                 const Vec3& along) noexcept {
    const PaintedGround& ground = *pattern.slopes->ground();
    const Vec3 inside = weights.cwiseMax(0);
    const Eigen::Vector3f way = along.cast<float>();
    double squares = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Eigen::Matrix3f& spread = ground.spread[ground.place[pattern.soup->triangles[triangle][k]]];
        squares += inside[Eigen::Index(k)] * double(way.dot(spread * way));
    }
    return std::sqrt(squares / inside.sum());
}

/// Along the way in which it passes, where a feature spans places of the mesh: as wide as what these do not
/// leave out already, for widths of filters in a row add up by their squares.
Row rowOf(const CompiledPattern& pattern, const TexturePoint& point, const Triangle& t) noexcept {
    constexpr double kFeatures = 3, kMostSpacings = 12, kApart = 0.75;
    const Vec3 across = acrossOf(t);
    const double area = across.squaredNorm();
    const Vec3 way = point.passing - across * (across.dot(point.passing) / area);
    const double feature = way.norm();
    if (!(feature > 0)) return {};
    const double spacing = spacingAt(pattern, point.triangle, point.weights, way / feature);
    if (!(feature > spacing)) return {};
    const double spacings =
        std::min(kFeatures * std::sqrt(feature * feature / (spacing * spacing) - 1), kMostSpacings);
    const Vec3 along = kApart * spacing / feature * way;
    return {int(0.5 * spacings / kApart), spacings / kApart,
            Vec3((t.c - t.b).cross(along).dot(across), (t.a - t.c).cross(along).dot(across),
                 (t.b - t.a).cross(along).dot(across)) /
                area};
}

/// (1 - x^2)^3 from end to end, times 1 + b x^2 with the b that lets what is quadratic along the row be: of
/// waves as long as a third of it nothing is left, of those from two and two thirds of it on all.
class RowWeights {
public:
    explicit RowWeights(const Row& row) noexcept : scale_(4 / (row.length * row.length)) {
        double squares = 0, fourths = 0;
        for (int i = 1; i <= row.places; ++i) {
            const double square = scale_ * i * i;
            squares += window(square) * square;
            fourths += window(square) * square * square;
        }
        b_ = -squares / fourths;
    }
    double at(int i) const noexcept {
        const double square = scale_ * i * i;
        return window(square) * (1 + b_ * square);
    }

private:
    static double window(double square) noexcept {
        const double inside = 1 - square;
        return inside * inside * inside;
    }
    double scale_, b_;
};

Rise averaged(const CompiledPattern& pattern, const TexturePoint& point, const Triangle& t) noexcept {
    const Row row = rowOf(pattern, point, t);
    if (row.places < 2) return onSurface(pattern, point.triangle, point.weights); // one weighs nothing yet
    const RowWeights weights(row);
    Rise sum;
    double all = 0;
    for (int i = -row.places; i <= row.places; ++i) {
        const double weight = weights.at(i);
        const Rise one = onSurface(pattern, point.triangle, point.weights + i * row.apart);
        sum.value += weight * one.value;
        sum.slope += weight * one.slope;
        all += weight;
    }
    return {sum.value / all, sum.slope / all};
}

/// Beside a hard edge the cubic would leave 0 to 1: more and more slowly, so that the slope does not jump.
Rise keptNearRange(const Rise& rise) noexcept {
    constexpr double kFarthest = 0.01;
    const double end = std::clamp(rise.value, 0.0, 1.0), beyond = rise.value - end,
                 slower = 1 / (1 + std::abs(beyond) / kFarthest);
    return {end + slower * beyond, slower * slower * rise.slope};
}

} // namespace

std::array<Vec3, 3> paintedSlopes(const CompiledPattern& pattern, Index triangle) noexcept {
    const Triangle t = cornersOf(*pattern.soup, triangle);
    const Vec3 flat = linearSlope(t, valuesAt(pattern, triangle));
    const Vec3 normal = (t.b - t.a).cross(t.c - t.a).normalized();
    std::array<Vec3, 3> slopes;
    for (std::size_t k = 0; k < 3; ++k)
        slopes[k] = pattern.slopes->at(pattern.soup->triangles[triangle][k], normal, flat);
    return slopes;
}

TextureField samplePainted(const CompiledPattern& pattern, const TexturePoint& point) noexcept {
    if (point.triangle >= pattern.soup->triangles.size()) return {};
    const auto& corners = pattern.soup->triangles[point.triangle];
    const Triangle triangle = cornersOf(*pattern.soup, point.triangle);
    const bool hasPlane = (triangle.b - triangle.a).cross(triangle.c - triangle.a).squaredNorm() > 0;
    const Rise rise = hasPlane ? averaged(pattern, point, triangle)
                               : onSegment(triangle, valuesAt(pattern, point.triangle), point.weights,
                                           corners[1] == corners[2]);
    const Rise kept = keptNearRange(rise);
    return {kept.value, kept.slope - kept.slope.dot(point.normal) * point.normal};
}

} // namespace tactum
