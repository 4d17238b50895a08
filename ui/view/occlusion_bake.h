// How open to the light every place about a scene is, made once for all pictures of it. Private to this
// folder.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ui/view/shadow_caster.h"

namespace tactum {

/// A grid of cubes about what stands still. Of each the mean openness over all directions, and the direction
/// that it is open toward: the first four of the spherical harmonics, which give the openness of a surface by
/// its normal (R. Ramamoorthi and P. Hanrahan, An Efficient Representation for Irradiance Environment Maps,
/// 2001, eq. 8 to 12, up to l = 1). So it serves meshes of any triangles, the largest as well.
struct OcclusionVolume {
    Vec3 corner = Vec3::Zero();        ///< the lowest of the grid, world frame
    double voxel = 0;                  ///< m, a cube's side
    std::array<int, 3> count{0, 0, 0}; ///< of cubes along x, y, z; 0: nothing takes light away
    /// Four to a cube, x the fastest: (0.5 + b) and a, 0 to 255 for 0 to 1, of the openness a + b n.
    std::vector<std::uint8_t> values;

    bool empty() const { return values.empty(); }
    /// How far off its surface, along the normal, a place is looked up, m: where cubes do not hold the
    /// surface itself.
    double offset() const { return 1.8 * voxel; }
    /// 0 to 1 of the light of a hemisphere of even light over a place of a surface, as the shader has it.
    double openness(const Vec3& p_W, const Vec3& normal_W) const;
};

/// How fine it is, and how far something takes light away.
struct OcclusionDetail {
    int along = 96;      ///< cubes along the longest side of the scene
    double reach = 0.25; ///< of that side; less with the distance, by its square
};

/// What moves by itself or by forces takes none. Nothing for cancelled work. Thread: any but real time.
std::optional<OcclusionVolume> occlusionOf(std::span<const ShadowCaster> casters, const Progress& progress,
                                           const OcclusionDetail& detail = {});

} // namespace tactum
