// A raster over a surface's texture coordinates: which triangle lies under each texel.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/progress.h"
#include "core/geometry/triangle_soup.h"

namespace tactum {

/// Texels over a rectangle of texture coordinates; row 0 at its lower edge, as in TextureImage.
struct UvCanvas {
    Eigen::Vector2d low = Eigen::Vector2d::Zero();  ///< u and v of the lower left corner
    Eigen::Vector2d size = Eigen::Vector2d::Ones(); ///< in units of u and v
    int width = 1, height = 1;                      ///< texels

    std::size_t texels() const { return std::size_t(width) * std::size_t(height); }
    /// The coordinates of a texel's centre.
    Eigen::Vector2d uvAt(int x, int y) const {
        return low + size.cwiseProduct(Eigen::Vector2d((x + 0.5) / width, (y + 0.5) / height));
    }
};

/// The unit square when all coordinates of the surface lie in it, else the smallest rectangle of whole units
/// around them. The surface must have coordinates that are finite. Thread: any but real time.
UvCanvas uvRectangleOf(const TriangleSoup& soup, Index surface);

/// What lies under the texels' centres.
struct UvCover {
    static constexpr Index kNothing = ~Index{0};

    std::vector<Index> triangleOf; ///< row by row; kNothing beside the surface
    std::size_t overlaps = 0;      ///< texels on which different places of the surface lie
    std::size_t withoutArea = 0;   ///< triangles with an area in space and none on the canvas
};

/// The cover, continued for two texels beyond the surface's edges so that an interpolation finds neighbours
/// there. Of no use after a cancel. Thread: any but real time; time goes with texels and with triangles times
/// the rows that they cross.
UvCover coverOf(const UvCanvas& canvas, const TriangleSoup& soup, Index surface,
                const Progress& progress = {});

/// The weights of a triangle's corners at a place on the canvas, also beside the triangle; sum 1.
/// Not finite for a triangle without area there.
Vec3 uvWeights(const TriangleSoup& soup, std::size_t triangle, const Eigen::Vector2d& uv);

} // namespace tactum
