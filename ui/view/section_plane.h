// The plane that cuts the model open in the view.
#pragma once

#include "core/base/vec.h"

namespace tactum {

/// What lies on the side that the z axis of the frame points to is cut away: it is neither drawn nor picked,
/// and felt as before. World frame, metre. Plain values. Thread: any.
struct SectionPlane {
    Pose frame; ///< X_WS: the origin is in the plane

    /// Unit length.
    Vec3 normal() const { return frame.rotate(Vec3::UnitZ()); }
    /// How far a point is on the side that is cut away, m; negative on the other one.
    double height(const Vec3& p_W) const { return normal().dot(p_W - frame.translation); }

    bool operator==(const SectionPlane&) const = default;
};

} // namespace tactum
