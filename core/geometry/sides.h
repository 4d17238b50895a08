// From which of its sides a triangle is felt.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/geometry/triangle.h"

namespace tactum {

/// The front sees the corners counter-clockwise. Segments and points have no sides: they are felt but for
/// None.
enum class Sides : std::uint8_t { Both, Front, Back, None };

/// What each is called on the command line and in files, in the order of the enumeration.
inline constexpr std::array<std::string_view, 4> kSidesNames{"both", "front", "back", "none"};

inline constexpr std::string_view nameOf(Sides sides) {
    return kSidesNames[std::size_t(sides)];
}
/// Nothing for a word that names no sides. Thread: any.
inline constexpr std::optional<Sides> sidesNamed(std::string_view name) {
    for (std::size_t i = 0; i < kSidesNames.size(); ++i)
        if (kSidesNames[i] == name) return Sides(i);
    return std::nullopt;
}

/// Whether a sphere that comes from p touches the triangle. Frame of the triangle. Thread: real time.
inline bool isFelt(Sides sides, const Triangle& triangle, const Vec3& p) noexcept {
    if (sides == Sides::Both) return true;
    if (sides == Sides::None) return false;
    const double height = (triangle.b - triangle.a).cross(triangle.c - triangle.a).dot(p - triangle.a);
    return sides == Sides::Front ? height >= 0 : height <= 0;
}

} // namespace tactum
