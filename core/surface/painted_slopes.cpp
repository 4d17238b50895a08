#include "core/surface/painted_slopes.h"

#include <utility>

#include "core/base/realtime.h"
#include "core/geometry/face_graph.h"
#include "core/geometry/weld.h"

namespace tactum {

namespace {

// Normals whose cosine is lower share no plane.
constexpr double kLeastCommon = -0.8;

bool shareAPlane(const Vec3& one, const Vec3& other) noexcept {
    return one.dot(other) > kLeastCommon && other.squaredNorm() > 0.5;
}

// What lies across the unit vector `from`, turned by the shortest way so that it lies across `to`.
Vec3 turned(const Vec3& v, const Vec3& from, const Vec3& to) noexcept {
    return v - to.dot(v) / (1 + from.dot(to)) * (from + to);
}

Vec3 acrossOf(const Triangle& t) noexcept {
    return (t.b - t.a).cross(t.c - t.a);
}

// Calls see(corners, triangle, its edges' product) for those of a surface that have a plane.
template <class See> void eachWithAPlane(const TriangleSoup& soup, Index surface, See&& see) {
    for (Index i = 0; i < soup.triangles.size(); ++i) {
        if (soup.surfaceOf[i] != surface) continue;
        const Triangle t = cornersOf(soup, i);
        const Vec3 across = acrossOf(t);
        if (across.squaredNorm() > 0) see(soup.triangles[i], t, across);
    }
}

} // namespace

Vec3 linearSlope(const Triangle& t, const Vec3& values) noexcept {
    const Vec3 across = acrossOf(t), toB = (values[1] - values[0]) * (t.c - t.a),
               toC = (values[2] - values[0]) * (t.b - t.a);
    const Vec3 slope = (toB - toC).cross(across) / across.squaredNorm();
    return slope.allFinite() ? slope : Vec3::Zero();
}

PaintedGround::PaintedGround(const std::shared_ptr<const TriangleSoup>& soup, Index ofSurface)
    : surface(ofSurface), place(weldMap(soup->positions)), normal(soup->positions.size()),
      across(soup->triangles.size(), {kNothing, kNothing, kNothing}) {
    assertNotRealtime();
    std::vector<Vec3> sums(normal.size(), Vec3::Zero());
    eachWithAPlane(*soup, surface, [&](const auto& corners, const Triangle&, const Vec3& product) {
        for (const Index corner : corners)
            sums[place[corner]] += product;
    });
    for (std::size_t i = 0; i < sums.size(); ++i)
        normal[i] = sums[i].stableNormalized().cast<float>();
    const auto graph = FaceGraph::build(soup); // fails only when it is cancelled
    for (Index i = 0; graph && i < soup->triangles.size(); ++i)
        for (int side = 0; side < 3; ++side) {
            const FaceGraph::Edge edge = graph->edgeOf(i, side);
            if (edge != FaceGraph::Edge::Joint && edge != FaceGraph::Edge::Flipped) continue;
            const Index other = graph->neighbour(i, side);
            if (soup->surfaceOf[other] == surface) across[i][std::size_t(side)] = other;
        }
}

PaintedSlopes::PaintedSlopes(const TriangleSoup& soup, std::shared_ptr<const PaintedGround> ground,
                             const PaintedValues& values)
    : ground_(std::move(ground)), rise_(soup.positions.size(), Eigen::Vector3f::Zero()) {
    assertNotRealtime();
    std::vector<Vec3> sums(rise_.size(), Vec3::Zero());
    std::vector<double> areas(rise_.size());
    eachWithAPlane(soup, ground_->surface, [&](const auto& corners, const Triangle& t, const Vec3& across) {
        const Vec3 slope = linearSlope(t, {values[corners[0]], values[corners[1]], values[corners[2]]});
        const double area = across.norm();
        for (const Index corner : corners) {
            const Index place = ground_->place[corner];
            const Vec3 normal = ground_->normal[place].template cast<double>();
            if (!shareAPlane(across / area, normal)) continue;
            sums[place] += area * turned(slope, across / area, normal);
            areas[place] += area;
        }
    });
    for (std::size_t i = 0; i < sums.size(); ++i)
        if (areas[i] > 0) rise_[i] = (sums[i] / areas[i]).cast<float>();
}

Vec3 PaintedSlopes::at(Index position, const Vec3& normal, const Vec3& otherwise) const noexcept {
    const Index place = ground_->place[position];
    const Vec3 there = ground_->normal[place].cast<double>();
    return shareAPlane(normal, there) ? turned(rise_[place].cast<double>(), there, normal) : otherwise;
}

} // namespace tactum
