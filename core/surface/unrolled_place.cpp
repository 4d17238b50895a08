#include "core/surface/unrolled_place.h"

namespace tactum {

namespace {

Vec3 placeOf(const Triangle& t, const Vec3& weights) noexcept {
    return weights[0] * t.a + weights[1] * t.b + weights[2] * t.c;
}

// Of a point in the plane of a triangle; no numbers where that has none.
Vec3 weightsOf(const Triangle& t, const Vec3& p) noexcept {
    const Vec3 across = (t.b - t.a).cross(t.c - t.a);
    const Vec3 a = t.a - p, b = t.b - p, c = t.c - p;
    return Vec3(b.cross(c).dot(across), c.cross(a).dot(across), a.cross(b).dot(across)) /
           across.squaredNorm();
}

// From an edge toward a point, across it.
Vec3 awayFrom(const Vec3& edge, const Vec3& way) noexcept {
    return (way - edge * edge.dot(way)).normalized();
}

} // namespace

UnrolledPlace::UnrolledPlace(const TriangleSoup& soup, const PaintedGround& ground, Index triangle,
                             const Vec3& weights) noexcept
    : soup_(soup), ground_(ground), triangle_(triangle), corners_(cornersOf(soup, triangle)),
      weights_(weights) {
    while (crossings_ < kMostCrossed && cross()) {
    }
}

// Over the edge that it lies farthest beyond.
bool UnrolledPlace::cross() noexcept {
    constexpr double kOnTheEdge = -1e-9;
    int opposite = 0;
    if (!(weights_.minCoeff(&opposite) < kOnTheEdge)) return false;
    const Index next = ground_.across[triangle_][std::size_t((opposite + 1) % 3)];
    if (next == PaintedGround::kNothing) return false;
    const std::array<Vec3, 3> corner{corners_.a, corners_.b, corners_.c};
    const Vec3 from = corner[std::size_t((opposite + 1) % 3)],
               edge = (corner[std::size_t((opposite + 2) % 3)] - from).normalized();
    const Triangle there = cornersOf(soup_, next);
    const Crossing crossing{edge, -awayFrom(edge, corner[std::size_t(opposite)] - from),
                            awayFrom(edge, placeOf(there, Vec3::Constant(1.0 / 3)) - from)};
    const Vec3 way = placeOf(corners_, weights_) - from;
    const Vec3 weights =
        weightsOf(there, from + edge * edge.dot(way) + crossing.behind * crossing.before.dot(way));
    if (!weights.allFinite()) return false;
    crossed_[crossings_++] = crossing;
    triangle_ = next;
    corners_ = there;
    weights_ = weights;
    return true;
}

Vec3 UnrolledPlace::turnedBack(Vec3 along) const noexcept {
    for (std::size_t i = crossings_; i-- > 0;)
        along = crossed_[i].edge * crossed_[i].edge.dot(along) +
                crossed_[i].before * crossed_[i].behind.dot(along);
    return along;
}

} // namespace tactum
