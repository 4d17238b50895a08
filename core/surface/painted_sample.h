// Painted values at a point of a mesh: a smooth surface through the values at its positions.
#pragma once

#include <array>

#include "core/surface/texture_field.h"
#include "core/surface/texture_mapping.h"

namespace tactum {

/// Value and gradient of a pattern whose source is Painted. Over a triangle the value is a cubic in three
/// parts whose slope does not jump, neither between them nor from triangle to triangle (R. W. Clough and
/// J. L. Tocher, Finite element stiffness matrices for analysis of plate bending, 1965); along a segment it
/// is linear. What is cubic in a plane is met exactly. The gradient is that of the value, tangent to the
/// normal of the point; zero on a point and on slivers without a plane. Beside a hard edge values are up to a
/// hundredth below 0 or above 1. Where places of the mesh lie closer than `point.passing` is long it is the
/// mean along that, so that what passes too fast for the steps is not felt as something else: at most
/// 17 samples, over twelve places of the mesh. Thread: real time.
TextureField samplePainted(const CompiledPattern& pattern, const TexturePoint& point) noexcept;

/// The slopes at the corners of a triangle, in its plane: body frame, 1/m. Thread: real time.
std::array<Vec3, 3> paintedSlopes(const CompiledPattern& pattern, Index triangle) noexcept;

} // namespace tactum
