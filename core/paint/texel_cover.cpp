#include "core/paint/texel_cover.h"

#include <algorithm>
#include <cmath>

#include "core/base/realtime.h"
#include "core/geometry/triangle.h"

namespace tactum {
namespace {

using Eigen::Vector2d;

int texelOf(double place) {
    constexpr double kFarthest = 1e8;
    return int(std::floor(std::clamp(place, -kFarthest, kFarthest)));
}

} // namespace

TexelMap texelMapOf(const CompiledPattern& pattern) {
    TexelMap map;
    map.width = pattern.image->width(), map.height = pattern.image->height();
    const Eigen::Matrix2d texels = Vector2d(map.width, map.height).asDiagonal() * pattern.repeatsPerMetre;
    map.perUv = texels * pattern.metresPerUv;
    map.shift = -texels * pattern.offset;
    return map;
}

TexelBox TexelBox::around(const Vector2d& least, const Vector2d& most) {
    return {{texelOf(least.x()), texelOf(least.y())}, {texelOf(most.x()) + 1, texelOf(most.y()) + 1}};
}

TexelTriangle::TexelTriangle(const TriangleSoup& soup, Index triangle, const TexelMap& map) {
    for (std::size_t k = 0; k < 3; ++k)
        corners_[k] = map.perUv * soup.cornerUvs[3 * std::size_t(triangle) + k].cast<double>() + map.shift;
    perArea_ = 1 / crossed(corners_[1] - corners_[0], corners_[2] - corners_[0]);
}

std::pair<Vec3, double> TexelTriangle::nearestTo(const Vector2d& place) const {
    const auto flat = [](const Vector2d& p) { return Vec3(p.x(), p.y(), 0); };
    const ClosestPoint closest =
        closestPoint({flat(corners_[0]), flat(corners_[1]), flat(corners_[2])}, flat(place));
    return {closest.weights, (closest.point - flat(place)).norm()};
}

TexelCover::TexelCover(const TriangleSoup& soup, const PaintableSurfaces& surfaces, const TexelMap& map)
    : map_(map), covered_(map.texels(), 0) {
    assertNotRealtime();
    // Coordinates that repeat the image more often leave no texel uncovered, and no time to look at them all.
    constexpr double kMaxCovers = 64;
    budget_ = kMaxCovers * double(map.texels()) + 1e6;
    if (soup.cornerUvs.empty()) return;
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        if (!surfaces(soup.surfaceOf[i])) continue;
        const TexelTriangle triangle(soup, Index(i), map);
        if (triangle.hasArea()) add(triangle);
        if (budget_ < 0) break;
    }
    if (budget_ < 0) covered_.assign(map.texels(), 1);
}

void TexelCover::add(const TexelTriangle& triangle) {
    const auto& [a, b, c] = triangle.corners();
    const TexelBox box = TexelBox::around(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c));
    for (int y = box.low.y(); y < box.high.y() && budget_ >= 0; ++y)
        addRow(triangle, y, box.low.x(), box.high.x());
}

/// Each weight is linear along the row, so that the texels inside are an interval.
void TexelCover::addRow(const TexelTriangle& triangle, int y, double left, double right) {
    constexpr double kRounding = 1e-9;
    const Vec3 begin = triangle.weightsAt({0.5, y + 0.5}), step = triangle.weightsAt({1.5, y + 0.5}) - begin;
    --budget_;
    ++lookedAt_;
    for (int k = 0; k < 3; ++k) {
        const double zero = (-kRounding - begin[k]) / step[k];
        if (step[k] > 0) left = std::max(left, zero);
        if (step[k] < 0) right = std::min(right, zero);
        if (step[k] == 0 && begin[k] < -kRounding) return;
    }
    if (!(left <= right)) return;
    const int first = int(std::ceil(left)), end = int(std::floor(right)) + 1;
    budget_ -= end - first;
    if (budget_ < 0) return;
    lookedAt_ += std::size_t(end - first);
    for (int x = first; x < end; ++x)
        covered_[map_.wrapped(x, y)] = 1;
}

} // namespace tactum
