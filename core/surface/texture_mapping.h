// From a place on a surface to a place on a flat pattern, with the gradient.
#pragma once

#include <array>

#include "core/geometry/triangle.h"
#include "core/geometry/triangle_soup.h"
#include "core/surface/texture_field.h"
#include "core/surface/texture_stack.h"

namespace tactum {

/// Where a texture is felt. Body frame.
struct TexturePoint {
    Vec3 position = Vec3::Zero();                 ///< m
    Vec3 normal = Vec3::UnitZ();                  ///< of unit length, toward the proxy
    Eigen::Vector2d uv = Eigen::Vector2d::Zero(); ///< the mesh's texture coordinates
    /// d uv / d position along the surface, 1/m; zero when there are no texture coordinates.
    Eigen::Matrix<double, 2, 3> uvGradient = Eigen::Matrix<double, 2, 3>::Zero();
    /// d normal / d position along the surface, 1/m; zero where the normal is that of a facet.
    Mat3 normalGradient = Mat3::Zero();
    Index triangle = 0;                      ///< of the mesh: what is painted asks for it
    Vec3 weights{1.0 / 3, 1.0 / 3, 1.0 / 3}; ///< of its corners at `position`; sum 1
    /// The smallest feature that passes slowly enough to be felt, and which way it passes, m: what is painted
    /// is filtered along it.
    Vec3 passing = Vec3::Zero();
};

/// The texture coordinates of a triangle's corners.
using CornerUvs = std::array<Eigen::Vector2d, 3>;

/// d uv / d position of the map that is linear on the triangle, in 1/m, whatever scale, mirror image or skew
/// its coordinates have. Zero for segments, points and slivers without a plane, and for coordinates that are
/// all the same or not finite. Thread: real time.
Eigen::Matrix<double, 2, 3> uvGradientOf(const Triangle& triangle, const CornerUvs& uvs) noexcept;

/// A place of a triangle of a mesh. `closest`: its point and its weights, body frame; `normal`: of the
/// surface there as it is without the texture. Thread: real time.
TexturePoint texturePointOn(const TriangleSoup& soup, Index index, const Triangle& triangle,
                            const ClosestPoint& closest, const Vec3& normal) noexcept;

/// A pattern's places for one point of the surface: one, or up to three that are blended.
struct FlatPoints {
    std::array<FlatPoint, 3> point;
    std::array<double, 3> weight{};                                               ///< sum 1
    std::array<Vec3, 3> weightGradient{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}; ///< 1/m, body frame
    int count = 0;
};

/// Where the point lies on the pattern. The gradients are tangent to the surface.
///
/// On the axis of a cylinder and at the poles of a sphere the meridians meet and the gradient of the
/// longitude grows without bound: it stops growing at kPole of the mapping's radius from there (and the band
/// limit has faded what is that fine long before). Triplanar weights change with the normal, as far as
/// `normalGradient` tells. Thread: real time.
FlatPoints flatPoints(const CompiledPattern& pattern, const TexturePoint& point) noexcept;

inline constexpr double kPole = 0.01;

} // namespace tactum
