// Where balls, capsules and cylinders touch each other: one formula for each pair. For this folder.
// Thread: real time.
#pragma once

#include <optional>

#include "core/dynamics/round/round_body.h"
#include "core/dynamics/touch.h"

namespace tactum {

/// As touchPoints(). Nothing where one of them is not round, or where no formula is for how they lie: then
/// they are two polytopes.
std::optional<TouchPoints> touchRound(const Convex& a, const Pose& a_W, const Convex& b, const Pose& b_W,
                                      double margin) noexcept;

// The normals point from the first to the second.
using RoundPair = std::optional<TouchPoints>(const RoundBody& a, const RoundBody& b, double margin) noexcept;
RoundPair ballAndBall, ballAndCapsule, ballAndCylinder, capsuleAndCapsule, capsuleAndCylinder,
    cylinderAndCylinder;

} // namespace tactum
