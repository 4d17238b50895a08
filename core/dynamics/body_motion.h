// Where a body was and is: the sweep of section 2.1 runs in the body's own frame, so that a wall that moves
// onto the proxy pushes it and never passes it.
#pragma once

#include "core/base/vec.h"

namespace tactum {

struct BodyMotion {
    Pose before; ///< X_WB at the last step
    Pose now;    ///< X_WB at this step

    /// The point of the world that the body's material carries p_W to. Thread: real time.
    Vec3 carried(const Vec3& p_W) const { return now.apply(before.applyInverse(p_W)); }
};

} // namespace tactum
