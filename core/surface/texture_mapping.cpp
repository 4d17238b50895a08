#include "core/surface/texture_mapping.h"

#include <algorithm>
#include <cmath>

namespace tactum {
namespace {

using Eigen::Vector2d;
using Gradient = Eigen::Matrix<double, 2, 3>;

/// A place in metres over the flat pattern, before it is moved, turned and scaled. The gradient is along the
/// surface, in the body frame.
struct Place {
    Vector2d metres;
    Gradient gradient;
};

/// A point in the frame of a mapping. The rows of `along` are the gradients of its coordinates along the
/// surface.
struct Framed {
    Vec3 p, normal;
    Mat3 along;
};

Framed inFrame(const CompiledPattern& pattern, const TexturePoint& point) noexcept {
    const Vec3 normal = pattern.axes * point.normal;
    return {pattern.axes * (point.position - pattern.origin), normal,
            pattern.axes - normal * point.normal.transpose()};
}

/// Seen along an axis of the frame, upright and never mirrored from either side.
Place alongAxis(const Framed& framed, int axis, double side) noexcept {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    Place place{{side * framed.p[u], framed.p[v]}, {}};
    place.gradient.row(0) = side * framed.along.row(u);
    place.gradient.row(1) = framed.along.row(v);
    return place;
}

/// The gradient of the longitude about z, in the mapping frame.
Vec3 longitudeGradient(const Vec3& p, double pole) noexcept {
    return Vec3(-p.y(), p.x(), 0) / std::max(p.x() * p.x() + p.y() * p.y(), pole * pole);
}

Place aroundAxis(const CompiledPattern& pattern, const Framed& framed) noexcept {
    const Vec3& p = framed.p;
    Gradient gradient = Gradient::Zero();
    gradient.row(0) = pattern.metresPerRadian * longitudeGradient(p, kPole * pattern.radius);
    gradient(1, 2) = 1;
    return {{pattern.metresPerRadian * std::atan2(p.y(), p.x()), p.z()}, gradient * framed.along};
}

Place onSphere(const CompiledPattern& pattern, const Framed& framed) noexcept {
    const Vec3& p = framed.p;
    const double pole = kPole * pattern.radius, across = std::hypot(p.x(), p.y());
    const double away = std::max(across, 1e-3 * pole); // at the pole itself every direction leads south
    Gradient gradient;
    gradient.row(0) = pattern.metresPerRadian * longitudeGradient(p, pole);
    gradient.row(1) = pattern.radius * Vec3(-p.x() * p.z() / away, -p.y() * p.z() / away, across) /
                      std::max(p.squaredNorm(), pole * pole);
    return {{pattern.metresPerRadian * std::atan2(p.y(), p.x()), pattern.radius * std::atan2(p.z(), across)},
            gradient * framed.along};
}

Place onCoordinates(const CompiledPattern& pattern, const TexturePoint& point) noexcept {
    const Gradient gradient = pattern.metresPerUv * point.uvGradient;
    return {pattern.metresPerUv * point.uv,
            gradient - (gradient * point.normal).eval() * point.normal.transpose()};
}

void add(FlatPoints& points, const CompiledPattern& pattern, const Place& place, double weight) noexcept {
    const auto i = std::size_t(points.count++);
    points.point[i].at.noalias() = pattern.repeatsPerMetre * (place.metres - pattern.offset);
    points.point[i].perMetre.noalias() = pattern.repeatsPerMetre * place.gradient;
    points.weight[i] = weight;
}

/// The fourth power of the normal's components; a side that counts for less than 1e-4 is spared.
void addTriplanar(FlatPoints& points, const CompiledPattern& pattern, const Framed& framed,
                  const Mat3& normalGradient) noexcept {
    const Vec3& n = framed.normal;
    const Vec3 powers = (n.array().square().square() - 1e-4).max(0.0);
    const double sum = powers.sum();
    // Of the powers and of their sum along the surface.
    const Vec3 rates = (powers.array() > 0).select(4 * n.array().cube(), 0.0);
    const Mat3 rise = rates.asDiagonal() * (pattern.axes * normalGradient);
    const Eigen::RowVector3d whole = rise.colwise().sum();
    for (int axis = 0; axis < 3; ++axis) {
        if (!(powers[axis] > 0)) continue;
        const double weight = powers[axis] / sum;
        points.weightGradient[std::size_t(points.count)] = (rise.row(axis) - weight * whole) / sum;
        add(points, pattern, alongAxis(framed, axis, n[axis] < 0 ? -1 : 1), weight);
    }
}

void addFramed(FlatPoints& points, const CompiledPattern& pattern, const Framed& framed,
               const Mat3& normalGradient) noexcept {
    switch (pattern.mapping) {
    case TextureMapping::Triplanar:
        addTriplanar(points, pattern, framed, normalGradient);
        break;
    case TextureMapping::Cylindrical:
        add(points, pattern, aroundAxis(pattern, framed), 1);
        break;
    case TextureMapping::Spherical:
        add(points, pattern, onSphere(pattern, framed), 1);
        break;
    default:
        add(points, pattern, alongAxis(framed, 2, 1), 1);
    }
}

} // namespace

Gradient uvGradientOf(const Triangle& triangle, const CornerUvs& uvs) noexcept {
    const Vec3 b = triangle.b - triangle.a, c = triangle.c - triangle.a, n = b.cross(c);
    const double area = n.squaredNorm(); // (b, c) squared, by the cross product: without cancellation
    if (!(area > 1e-24 * b.squaredNorm() * c.squaredNorm())) return Gradient::Zero();
    // The vectors in the triangle's plane whose products with (b, c) are (1, 0) and (0, 1).
    const Vec3 alongB = c.cross(n) / area, alongC = n.cross(b) / area;
    const Gradient gradient = (uvs[1] - uvs[0]) * alongB.transpose() + (uvs[2] - uvs[0]) * alongC.transpose();
    return gradient.allFinite() ? gradient : Gradient::Zero();
}

TexturePoint texturePointOn(const TriangleSoup& soup, Index index, const Triangle& triangle,
                            const ClosestPoint& closest, const Vec3& normal) noexcept {
    TexturePoint point;
    point.position = closest.point;
    point.normal = normal;
    point.triangle = index;
    point.weights = closest.weights;
    if (soup.cornerUvs.empty()) return point;
    CornerUvs corners;
    for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = soup.cornerUvs[3 * std::size_t(index) + k].cast<double>();
        point.uv += closest.weights[Eigen::Index(k)] * corners[k];
    }
    point.uvGradient = uvGradientOf(triangle, corners);
    return point;
}

FlatPoints flatPoints(const CompiledPattern& pattern, const TexturePoint& point) noexcept {
    FlatPoints points;
    if (usesUvs(pattern))
        add(points, pattern, onCoordinates(pattern, point), 1);
    else
        addFramed(points, pattern, inFrame(pattern, point), point.normalGradient);
    return points;
}

} // namespace tactum
