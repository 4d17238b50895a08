// The shadow of bodies on the ground beneath them, as a picture. Private to this folder.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/base/vec.h"
#include "core/geometry/triangle_soup.h"
#include "ui/view/section_plane.h"

namespace tactum {

/// What casts a shadow: the surfaces of a body that are seen, where it is.
struct ShadowCaster {
    std::shared_ptr<const TriangleSoup> soup;
    std::vector<bool> seen; ///< of each surface
    Pose X_WB;
    bool moves = false;                       ///< by itself or by forces
    std::optional<SectionPlane> section = {}; ///< what it cuts away casts none

    bool operator==(const ShadowCaster&) const = default;
};

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
