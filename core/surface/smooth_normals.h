// What compiling makes of a mesh for force shading: a normal for each corner, and where they part.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/geometry/triangle_soup.h"
#include "core/surface/shading.h"

namespace tactum {

/// Immutable; shared between worlds so that an edit of a material computes no normals.
struct SmoothNormals {
    /// Three to a triangle, unit length, body frame: those of `soup`, or `computed`.
    std::span<const Eigen::Vector3f> corners;
    /// To each triangle six bits: k for the edge opposite to corner k, 3 + k for corner k. Set where the felt
    /// surface ends or has a crease: no triangle, more than one, or one of other normals goes on there.
    std::vector<std::uint8_t> seams;
    /// To each triangle the one that the felt surface goes on over the edge opposite to corner k; kNothing at
    /// a seam.
    std::vector<std::array<Index, 3>> across;
    static constexpr Index kNothing = ~Index(0);

    // What it was made of: to know whether it can be used again.
    std::shared_ptr<const TriangleSoup> soup;
    double creaseAngle = -1; ///< rad; negative: the normals of the file
    std::vector<Eigen::Vector3f> computed;
};

/// The normals that a surface of this mesh asks for; nothing when its shading is off. One among `known` that
/// was made of the same is returned itself. Fails only when cancelled. Thread: any but real time.
Result<std::shared_ptr<const SmoothNormals>>
compileNormals(const Shading& shading, const std::shared_ptr<const TriangleSoup>& soup,
               std::span<const std::shared_ptr<const SmoothNormals>> known = {},
               const Progress& progress = {});

} // namespace tactum
