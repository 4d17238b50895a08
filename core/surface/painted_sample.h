// Painted values at a point of a mesh: linear over each triangle.
#pragma once

#include "core/surface/texture_field.h"
#include "core/surface/texture_mapping.h"

namespace tactum {

/// Value and gradient of a pattern whose source is Painted. The gradient is constant over a triangle, or
/// along a segment, and tangent to the normal of the point; zero on a point and on slivers without a plane.
/// Thread: real time.
TextureField samplePainted(const CompiledPattern& pattern, const TexturePoint& point) noexcept;

} // namespace tactum
