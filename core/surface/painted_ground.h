// The shape of a surface that something is painted on: what lies around a place of it.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "core/geometry/triangle.h"
#include "core/geometry/triangle_soup.h"

namespace tactum {

/// What slopes on one surface of a mesh need to know of its shape, whatever is painted there.
struct PaintedGround {
    static constexpr Index kNothing = ~Index(0);

    /// Thread: any but real time. As long as FaceGraph takes: 0.4 s for a million triangles.
    PaintedGround(const std::shared_ptr<const TriangleSoup>& soup, Index surface);

    Index surface;
    std::vector<Index> place; ///< of each position the first one that lies where it does
    /// At each place, of the triangles around it, weighted by their area; zero where they have none.
    std::vector<Eigen::Vector3f> normal;
    /// At each place how far others are: along the unit vector d the square of it is d^T S d, m^2.
    std::vector<Eigen::Matrix3f> spread;
    /// Of each triangle the one over the edge from corner i to the next; kNothing where there is none, or
    /// more than one, or one of another surface.
    std::vector<std::array<Index, 3>> across;

    /// The triangles of the surface that have a plane.
    std::span<const Index> around(Index at) const noexcept {
        return std::span(around_).subspan(first_[at], first_[at + 1] - first_[at]);
    }

private:
    std::vector<Index> first_, around_;
};

/// The corners of a triangle of a mesh. Thread: real time.
inline Triangle cornersOf(const TriangleSoup& soup, Index triangle) noexcept {
    const auto& corner = soup.triangles[triangle];
    return {soup.positions[corner[0]], soup.positions[corner[1]], soup.positions[corner[2]]};
}

/// Across a triangle, twice its area long: m^2. Thread: real time.
inline Vec3 acrossOf(const Triangle& t) noexcept {
    return (t.b - t.a).cross(t.c - t.a);
}

/// Whether the planes across two unit normals are near enough to turn one into the other; `other` may be
/// zero. Thread: real time.
inline bool shareAPlane(const Vec3& one, const Vec3& other) noexcept {
    constexpr double kLeastCommon = -0.8;
    return one.dot(other) > kLeastCommon && other.squaredNorm() > 0.5;
}

/// What lies across the unit vector `from`, turned by the shortest way so that it lies across `to`. Thread:
/// real time.
inline Vec3 turned(const Vec3& v, const Vec3& from, const Vec3& to) noexcept {
    return v - to.dot(v) / (1 + from.dot(to)) * (from + to);
}

} // namespace tactum
