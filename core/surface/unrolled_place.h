// Where a place beside a triangle lies on the surface.
#pragma once

#include <array>
#include <cstddef>

#include "core/geometry/triangle.h"
#include "core/geometry/triangle_soup.h"
#include "core/surface/painted_slopes.h"

namespace tactum {

/// A place in the plane of a triangle, beside it perhaps, on the neighbour where it lies when that is turned
/// into this plane, and so on from neighbour to neighbour, twenty at most: as if the surface were unrolled.
/// Where there is none it stays beside the last one. Thread: real time.
class UnrolledPlace {
public:
    /// `weights`: of the corners of `triangle`, which has a plane; sum 1, below zero beside it.
    UnrolledPlace(const TriangleSoup& soup, const PaintedGround& ground, Index triangle,
                  const Vec3& weights) noexcept;

    Index triangle() const noexcept { return triangle_; }
    const Triangle& corners() const noexcept { return corners_; }
    const Vec3& weights() const noexcept { return weights_; }
    /// What lies in the plane of the triangle where the place is, turned back into that of the first one.
    Vec3 turnedBack(Vec3 along) const noexcept;

private:
    static constexpr std::size_t kMostCrossed = 20;

    /// An edge, and the unit vectors across it on both sides of it, in which the way over it goes.
    struct Crossing {
        Vec3 edge, before, behind;
    };
    bool cross() noexcept;

    const TriangleSoup& soup_;
    const PaintedGround& ground_;
    Index triangle_;
    Triangle corners_;
    Vec3 weights_;
    std::array<Crossing, kMostCrossed> crossed_;
    std::size_t crossings_ = 0;
};

} // namespace tactum
