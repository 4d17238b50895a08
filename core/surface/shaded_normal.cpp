#include "core/surface/shaded_normal.h"

#include <algorithm>
#include <cmath>

#include "core/surface/texture_mapping.h"

namespace tactum {
namespace {

// Interpolated normals shorter than this come from corners that face away from each other: they say nothing.
constexpr double kNoDirection = 1e-6;
// Cosine of the farthest that a boundary is felt as n'.
constexpr double kWidestMirror = 0.2;

Vec3 turnedTo(const Vec3& side, const Vec3& normal) noexcept {
    return normal.dot(side) < 0 ? Vec3(-normal) : normal;
}

// Not of unit length.
Vec3 interpolated(const SmoothNormals& normals, Index index, const Vec3& weights) noexcept {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k)
        sum += weights[Eigen::Index(k)] * normals.corners[3 * index + k].cast<double>();
    return sum;
}

bool isOnSeam(std::uint8_t seams, const ClosestPoint& closest) noexcept {
    if (seams == 0 || closest.feature == Feature::Face) return false;
    int corner = 0;
    if (closest.feature == Feature::Edge)
        closest.weights.cwiseAbs().minCoeff(&corner);
    else
        closest.weights.maxCoeff(&corner);
    const int bit = closest.feature == Feature::Edge ? corner : 3 + corner;
    return (seams >> bit) & 1;
}

// The hypothetical surface has the normal n' at the boundary. A facet that continued it would lie mirrored at
// n', so up to that one's normal the boundary is felt as n'; from there on n' gives way to the true normal,
// which stands alone as much farther as twice the angle by which n' leans from the facet, or at the tip,
// where upper and lower side meet. What does not lean is felt as it is.
Vec3 onHypotheticalSurface(const Vec3& interpolated, const Triangle& triangle, const Vec3& away) noexcept {
    const Vec3 plane = (triangle.b - triangle.a).cross(triangle.c - triangle.a);
    const double area = plane.norm();
    if (!(area > 0)) return away; // a segment or a point has no side to be tilted
    const Vec3 face = turnedTo(away, plane / area), felt = turnedTo(face, interpolated);
    const double height = away.dot(face);
    const Vec3 outward = away - height * face;
    const double lean = std::max(0.0, felt.dot(outward) / std::max(outward.norm(), kNoDirection));
    const double mirrored = std::max(1 - 2 * lean * lean, kWidestMirror);
    const double tilt = std::acos(std::min(felt.dot(face), 1.0));
    const double ends = std::max(std::cos(std::acos(mirrored) + 2 * tilt), 0.0);
    if (height >= mirrored) return felt;
    const double share = std::min((mirrored - height) / std::max(mirrored - ends, kNoDirection), 1.0);
    return ((1 - share) * felt + share * away).normalized();
}

} // namespace

Vec3 leaningAtMost(const Vec3& normal, const Vec3& away) noexcept {
    const double cosine = normal.dot(away);
    if (cosine >= kMaxLean) return normal;
    const Vec3 sideways = normal - cosine * away;
    const double length = sideways.norm();
    if (!(length > 0)) return away;
    return kMaxLean * away + std::sqrt(1 - kMaxLean * kMaxLean) / length * sideways;
}

Vec3 shadedNormal(const SmoothNormals& normals, Index index, const Triangle& triangle,
                  const ClosestPoint& closest, const Vec3& away) noexcept {
    const Vec3 sum = interpolated(normals, index, closest.weights);
    const double length = sum.norm();
    if (!(length > kNoDirection)) return away;
    const Vec3 felt = sum / length;
    if (isOnSeam(normals.seams[index], closest))
        return leaningAtMost(onHypotheticalSurface(felt, triangle, away), away);
    return leaningAtMost(turnedTo(away, felt), away);
}

Mat3 shadedNormalGradient(const SmoothNormals& normals, Index index, const Triangle& triangle,
                          const ClosestPoint& closest, const Vec3& normal) noexcept {
    const Vec3 sum = interpolated(normals, index, closest.weights);
    const double length = sum.norm();
    if (!(length > kNoDirection)) return Mat3::Zero();
    const Vec3 felt = sum / length;
    const auto corner = [&](int k) { return interpolated(normals, index, Vec3::Unit(k)); };
    Eigen::Matrix<double, 3, 2> change; // along the edges from the first corner
    change << corner(1) - corner(0), corner(2) - corner(0);
    const Mat3 gradient = change * uvGradientOf(triangle, {Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0),
                                                           Eigen::Vector2d(0, 1)});
    const Mat3 turning = (gradient - felt * (felt.transpose() * gradient)) / length;
    return felt.dot(normal) < 0 ? Mat3(-turning) : turning;
}

} // namespace tactum
