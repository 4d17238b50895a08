// How what is painted rises at the positions of a mesh: what makes it smooth between them. Built once, then
// only read.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/surface/painted_ground.h"
#include "core/surface/painted_values.h"

namespace tactum {

/// At each place of a mesh the slope of a cubic through its value, fitted to what is painted around it, and
/// along the sides of triangles how that changes (painted_fit.h). Shared through a shared_ptr to const.
class PaintedSlopes {
public:
    /// `values`: as many as the mesh has positions; `ground`: of this mesh. Thread: any but real time. O(n),
    /// on all cores: a second for half a million places that are painted, a tenth of that where nothing is.
    PaintedSlopes(const TriangleSoup& soup, std::shared_ptr<const PaintedGround> ground,
                  const PaintedValues& values);

    /// At a position, turned into the plane across `normal` (unit length) as if the surface were unrolled;
    /// `otherwise` where the triangles around it have no plane in common with that. Body frame, 1/m. Thread:
    /// real time.
    Vec3 at(Index position, const Vec3& normal, const Vec3& otherwise) const noexcept;

    /// What CloughTocher adds for the sides of a triangle, whose slopes across are not linear along them: no
    /// unit, of the side from corner i to the next. Thread: real time.
    const std::array<float, 3>& bulge(Index triangle) const noexcept { return bulge_[triangle]; }

    const std::shared_ptr<const PaintedGround>& ground() const noexcept { return ground_; }

private:
    std::shared_ptr<const PaintedGround> ground_;
    std::vector<Eigen::Vector3f> rise_; ///< at each place, across its normal
    std::vector<std::array<float, 3>> bulge_;
};

/// Of the function that is linear on a triangle and has these values at its corners: body frame, 1/m, in the
/// triangle's plane. Zero for segments, points and slivers without a plane. Thread: real time.
Vec3 linearSlope(const Triangle& triangle, const Vec3& values) noexcept;

} // namespace tactum
