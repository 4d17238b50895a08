// The shadow of bodies on the ground beneath them, as a picture. Private to this folder.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ui/view/shadow_caster.h"

namespace tactum {

/// A square of the world's ground plane, which is horizontal.
struct GroundShadow {
    Bounds casters;                 ///< of all; empty: there are none
    Vec3 corner = Vec3::Zero();     ///< the lowest x and z; y is the ground's
    double side = 0;                ///< m
    int texels = 0;                 ///< along a side
    std::vector<std::uint8_t> dark; ///< 0 to 255, rows of growing x one after the other in growing z
};

/// As soft as it is far below what casts it: coverage by the lowest triangle over each texel, in slices of
/// its height, each blurred and thinned with the height. `standing` alone: of what does not move. Nothing for
/// cancelled work. Thread: any but real time.
std::optional<GroundShadow> shadowOf(std::span<const ShadowCaster> casters, bool standing,
                                     const Progress& progress);

} // namespace tactum
