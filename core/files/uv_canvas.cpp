#include "core/files/uv_canvas.h"

#include <algorithm>
#include <cmath>

#include "core/base/realtime.h"

namespace tactum {
namespace {

using Eigen::Vector2d;

Vector2d uvOf(const TriangleSoup& soup, std::size_t corner) {
    return soup.cornerUvs[corner].cast<double>();
}

double crossed(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

Vec3 positionAt(const TriangleSoup& soup, std::size_t triangle, const Vec3& weights) {
    Vec3 p = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
        p += weights[k] * soup.positions[soup.triangles[triangle][std::size_t(k)]];
    return p;
}

bool hasArea(const TriangleSoup& soup, std::size_t triangle) {
    const auto& t = soup.triangles[triangle];
    const Vec3& a = soup.positions[t[0]];
    return (soup.positions[t[1]] - a).cross(soup.positions[t[2]] - a).squaredNorm() > 0;
}

/// Draws one triangle after the other.
class CoverPainter {
public:
    CoverPainter(const UvCanvas& canvas, const TriangleSoup& soup, const Progress& progress, UvCover& cover)
        : canvas_(canvas), soup_(soup), progress_(progress), cover_(cover), isInside_(canvas.texels(), false),
          kSamePlace_(1e-6 * boundsOf(soup).diagonal()) {}

    void paint(std::size_t triangle) {
        double lowV = 1e300, highV = -1e300;
        for (std::size_t k = 0; k < 3; ++k) {
            const double v = uvOf(soup_, 3 * triangle + k).y();
            lowV = std::min(lowV, v), highV = std::max(highV, v);
        }
        const int first = rowOf(lowV), last = std::min(rowOf(highV), canvas_.height - 1);
        for (int y = std::max(first, 0); y <= last && !progress_.isCancelled(); ++y)
            paintRow(triangle, y);
    }

private:
    static constexpr double kEdge = 1e-9; ///< weights: centres on an edge belong to the triangle
    static constexpr double kInside =
        1e-3; ///< weights: what is so far inside cannot be a neighbour's rounding

    int rowOf(double v) const {
        return int(std::clamp((v - canvas_.low.y()) / canvas_.size.y() * canvas_.height, -1.0, 1e6));
    }

    /// Each weight is linear along the row, so that the texels inside are an interval.
    void paintRow(std::size_t triangle, int y) {
        const Vec3 begin = uvWeights(soup_, triangle, canvas_.uvAt(0, y)),
                   step = uvWeights(soup_, triangle, canvas_.uvAt(1, y)) - begin;
        double from = 0, to = canvas_.width - 1;
        for (int k = 0; k < 3; ++k) {
            const double zero = (-kEdge - begin[k]) / step[k];
            if (step[k] > 0) from = std::max(from, zero);
            if (step[k] < 0) to = std::min(to, zero);
            if (step[k] == 0 && begin[k] < -kEdge) return;
        }
        if (!(from <= to)) return;
        for (int x = int(std::ceil(from)); x <= to; ++x)
            paintTexel(triangle, x, y);
    }

    void paintTexel(std::size_t triangle, int x, int y) {
        const std::size_t texel = std::size_t(y) * std::size_t(canvas_.width) + std::size_t(x);
        const Vec3 weights = uvWeights(soup_, triangle, canvas_.uvAt(x, y));
        const bool isInside = weights.minCoeff() > kInside;
        Index& owner = cover_.triangleOf[texel];
        if (isInside && isInside_[texel]) {
            const Vec3 other = uvWeights(soup_, owner, canvas_.uvAt(x, y));
            cover_.overlaps +=
                (positionAt(soup_, triangle, weights) - positionAt(soup_, owner, other)).norm() > kSamePlace_;
        } else if (isInside || owner == UvCover::kNothing) {
            owner = Index(triangle);
            isInside_[texel] = isInside;
        }
    }

    const UvCanvas& canvas_;
    const TriangleSoup& soup_;
    const Progress& progress_;
    UvCover& cover_;
    std::vector<bool> isInside_;
    const double kSamePlace_; ///< m
};

/// Every empty texel takes the triangle of a neighbour that has one.
void grow(const UvCanvas& canvas, const Progress& progress, std::vector<Index>& triangleOf) {
    const std::vector<Index> before = triangleOf;
    for (int y = 0; y < canvas.height && !progress.isCancelled(); ++y)
        for (int x = 0; x < canvas.width; ++x) {
            Index& own = triangleOf[std::size_t(y) * std::size_t(canvas.width) + std::size_t(x)];
            for (int k = 0; k < 9 && own == UvCover::kNothing; ++k) {
                const int i = x + k % 3 - 1, j = y + k / 3 - 1;
                if (i >= 0 && j >= 0 && i < canvas.width && j < canvas.height)
                    own = before[std::size_t(j) * std::size_t(canvas.width) + std::size_t(i)];
            }
        }
}

} // namespace

Vec3 uvWeights(const TriangleSoup& soup, std::size_t triangle, const Vector2d& uv) {
    const Vector2d a = uvOf(soup, 3 * triangle), b = uvOf(soup, 3 * triangle + 1) - a,
                   c = uvOf(soup, 3 * triangle + 2) - a, p = uv - a;
    const double area = crossed(b, c), second = crossed(p, c) / area, third = crossed(b, p) / area;
    return {1 - second - third, second, third};
}

UvCanvas uvRectangleOf(const TriangleSoup& soup, Index surface) {
    Vector2d low(0, 0), high(1, 1);
    bool first = true, isUnit = true;
    for (std::size_t corner = 0; corner < soup.cornerUvs.size(); ++corner) {
        if (soup.surfaceOf[corner / 3] != surface) continue;
        const Vector2d uv = uvOf(soup, corner);
        isUnit = isUnit && uv.minCoeff() >= 0 && uv.maxCoeff() <= 1;
        low = first ? uv : Vector2d(low.cwiseMin(uv));
        high = first ? uv : Vector2d(high.cwiseMax(uv));
        first = false;
    }
    if (isUnit) return {};
    UvCanvas canvas;
    canvas.low = low.array().floor();
    canvas.size = (high.array().ceil() - canvas.low.array()).max(1.0);
    return canvas;
}

UvCover coverOf(const UvCanvas& canvas, const TriangleSoup& soup, Index surface, const Progress& progress) {
    assertNotRealtime();
    UvCover cover;
    cover.triangleOf.assign(canvas.texels(), UvCover::kNothing);
    CoverPainter painter(canvas, soup, progress, cover);
    ProgressMeter meter(progress, soup.triangles.size(), 256);
    for (std::size_t i = 0; i < soup.triangles.size() && meter.goesOn(i); ++i) {
        if (soup.surfaceOf[i] != surface || !hasArea(soup, i)) continue;
        if (uvWeights(soup, i, canvas.low).allFinite())
            painter.paint(i);
        else
            ++cover.withoutArea;
    }
    for (int i = 0; i < 2; ++i)
        grow(canvas, progress, cover.triangleOf);
    return cover;
}

} // namespace tactum
