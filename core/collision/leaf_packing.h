// How few primitives are divided so that their leaves are full and round.
#pragma once

#include <cstddef>
#include <span>

#include "core/collision/leaf_cover.h"

namespace tactum {

/// What is not more than this is divided by `packLeaves`; at most this many fit.
inline constexpr std::size_t kMostPacked = 128;

/// Brings leaf spheres into an order of which the first so many (the result, at least one, not all) are one
/// part and the others the other one: along that of the two longer axes and at the place where both are the
/// smallest, by the square of their boxes' diagonals times the leaves that they fill. As large as its disc
/// is, so often a path comes by a patch of a surface, and then looks at all of its leaves. One part fills its
/// leaves. spheres: more than `leafSize`, at most kMostPacked. Thread: any. O(n log n).
std::size_t packLeaves(std::span<LeafSphere> spheres, std::size_t leafSize);

} // namespace tactum
