// From which of its sides a triangle is felt.
#pragma once

#include <cstdint>

#include "core/geometry/triangle.h"

namespace tactum {

/// The front sees the corners counter-clockwise. Segments and points have no sides: they are always felt.
enum class Sides : std::uint8_t { Both, Front, Back };

/// Whether a sphere whose centre is at p touches the triangle. Frame of the triangle. Thread: real time.
inline bool isFelt(Sides sides, const Triangle& triangle, const Vec3& p) noexcept {
    if (sides == Sides::Both) return true;
    const double height = (triangle.b - triangle.a).cross(triangle.c - triangle.a).dot(p - triangle.a);
    return sides == Sides::Front ? height >= 0 : height <= 0;
}

} // namespace tactum
