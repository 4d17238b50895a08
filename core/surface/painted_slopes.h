// How what is painted rises at the positions of a mesh: what makes it smooth between them. Built once, then
// only read.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/geometry/triangle.h"
#include "core/geometry/triangle_soup.h"
#include "core/surface/painted_values.h"

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
    /// Of each triangle the one over the edge from corner i to the next; kNothing where there is none, or
    /// more than one, or one of another surface.
    std::vector<std::array<Index, 3>> across;
};

/// At each place of a mesh the mean slope of the surface's triangles around it, weighted by their area.
/// Shared through a shared_ptr to const.
class PaintedSlopes {
public:
    /// `values`: as many as the mesh has positions; `ground`: of this mesh. Thread: any but real time. O(n).
    PaintedSlopes(const TriangleSoup& soup, std::shared_ptr<const PaintedGround> ground,
                  const PaintedValues& values);

    /// At a position, turned into the plane across `normal` (unit length) as if the surface were unrolled;
    /// `otherwise` where the triangles around it have no plane in common with that. Body frame, 1/m. Thread:
    /// real time.
    Vec3 at(Index position, const Vec3& normal, const Vec3& otherwise) const noexcept;

    const std::shared_ptr<const PaintedGround>& ground() const noexcept { return ground_; }

private:
    std::shared_ptr<const PaintedGround> ground_;
    std::vector<Eigen::Vector3f> rise_; ///< at each place, across its normal
};

/// The corners of a triangle of a mesh. Thread: real time.
inline Triangle cornersOf(const TriangleSoup& soup, Index triangle) noexcept {
    const auto& corner = soup.triangles[triangle];
    return {soup.positions[corner[0]], soup.positions[corner[1]], soup.positions[corner[2]]};
}

/// Of the function that is linear on a triangle and has these values at its corners: body frame, 1/m, in the
/// triangle's plane. Zero for segments, points and slivers without a plane. Thread: real time.
Vec3 linearSlope(const Triangle& triangle, const Vec3& values) noexcept;

} // namespace tactum
