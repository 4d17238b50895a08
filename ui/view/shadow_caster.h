// What of a scene takes light away from the rest of it, triangle by triangle. Private to this folder.
#pragma once

#include <array>
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

/// What a section leaves of a triangle: none, three or four corners, in their order.
std::vector<Vec3> keptOf(const std::array<Vec3, 3>& corners, const std::optional<SectionPlane>& section);

/// `visit`: is given the corners of each triangle that is seen, world frame, and the section. False for
/// cancelled work.
template <class Visit>
bool forEachTriangle(std::span<const ShadowCaster> casters, const Progress& progress, Visit visit) {
    for (const ShadowCaster& caster : casters) {
        const TriangleSoup& soup = *caster.soup;
        ProgressMeter meter(progress, soup.triangles.size());
        for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
            if (!meter.goesOn(i)) return false;
            if (!caster.seen[soup.surfaceOf[i]]) continue;
            std::array<Vec3, 3> corners;
            for (std::size_t k = 0; k < 3; ++k)
                corners[k] = caster.X_WB.apply(soup.positions[soup.triangles[i][k]]);
            visit(corners, caster.section);
        }
    }
    return !progress.isCancelled();
}

} // namespace tactum
