// The normal that a shaded surface is felt with at a contact (sections 3 and 3.1).
#pragma once

#include "core/geometry/triangle.h"
#include "core/surface/smooth_normals.h"

namespace tactum {

/// No felt normal leans away from the true one by more than 60 degrees: a steeper plane would hold the proxy
/// rather than guide it. Cosine.
inline constexpr double kMaxLean = 0.5;

/// `normal`, leaning no more than that away from `away`; both of unit length. Thread: real time.
Vec3 leaningAtMost(const Vec3& normal, const Vec3& away) noexcept;

/// The felt normal at a contact: the interpolated one, on the proxy's side, as the C-obstacle shows it.
/// `away`: the true normal there, from the closest point to the proxy's centre. Body frame, unit length.
///
/// Over a face, and on edges and corners over which the felt surface goes on, it is n', the corners' normals
/// with the weights of the contact. On a seam it is figure 7's hypothetical surface: n' as far as a facet
/// mirrored at n' would reach, then less and less of it toward the tip of the boundary (docs/physics).
/// Thread: real time.
Vec3 shadedNormal(const SmoothNormals& normals, Index index, const Triangle& triangle,
                  const ClosestPoint& closest, const Vec3& away) noexcept;

/// How n' changes along the triangle: d n' / d position, 1/m, body frame; of the normal on the side of
/// `normal`. Zero where the corners' normals are alike, and on triangles without a plane. Thread: real time.
Mat3 shadedNormalGradient(const SmoothNormals& normals, Index index, const Triangle& triangle,
                          const ClosestPoint& closest, const Vec3& normal) noexcept;

} // namespace tactum
