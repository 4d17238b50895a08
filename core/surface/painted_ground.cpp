#include "core/surface/painted_ground.h"

#include <algorithm>
#include <numeric>

#include "core/base/realtime.h"
#include "core/geometry/face_graph.h"
#include "core/geometry/weld.h"

namespace tactum {

namespace {

/// The mean of its sides' squares, so that the one along the rows of a grid of squares is their distance.
Mat3 squaresOfSides(const Triangle& t) {
    const Vec3 a = t.b - t.a, b = t.c - t.b, c = t.a - t.c;
    return 0.5 * (a * a.transpose() + b * b.transpose() + c * c.transpose());
}

} // namespace

PaintedGround::PaintedGround(const std::shared_ptr<const TriangleSoup>& soup, Index ofSurface)
    : surface(ofSurface), place(weldMap(soup->positions)), normal(soup->positions.size()),
      spread(soup->positions.size(), Eigen::Matrix3f::Zero()),
      across(soup->triangles.size(), {kNothing, kNothing, kNothing}), first_(soup->positions.size() + 1) {
    assertNotRealtime();
    std::vector<Vec3> sums(normal.size(), Vec3::Zero());
    std::vector<Index> ours;
    for (Index i = 0; i < soup->triangles.size(); ++i) {
        if (soup->surfaceOf[i] != surface) continue;
        const Triangle t = cornersOf(*soup, i);
        const Vec3 product = acrossOf(t);
        if (!(product.squaredNorm() > 0)) continue;
        const Eigen::Matrix3f squares = squaresOfSides(t).cast<float>();
        ours.push_back(i);
        for (const Index corner : soup->triangles[i]) {
            sums[place[corner]] += product;
            spread[place[corner]] += squares;
            ++first_[place[corner] + 1];
        }
    }
    for (std::size_t i = 0; i < sums.size(); ++i)
        normal[i] = sums[i].stableNormalized().cast<float>();
    for (std::size_t i = 0; i < spread.size(); ++i)
        spread[i] /= float(std::max<Index>(first_[i + 1], 1));
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    around_.resize(first_.back());
    std::vector<Index> next(first_.begin(), first_.end() - 1);
    for (const Index i : ours)
        for (const Index corner : soup->triangles[i])
            around_[next[place[corner]]++] = i;
    const auto graph = FaceGraph::build(soup); // fails only when it is cancelled
    for (Index i = 0; graph && i < soup->triangles.size(); ++i)
        for (int side = 0; side < 3; ++side) {
            const FaceGraph::Edge edge = graph->edgeOf(i, side);
            if (edge != FaceGraph::Edge::Joint && edge != FaceGraph::Edge::Flipped) continue;
            const Index other = graph->neighbour(i, side);
            if (soup->surfaceOf[other] == surface) across[i][std::size_t(side)] = other;
        }
}

} // namespace tactum
