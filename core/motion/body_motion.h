// Where a body was and is: the sweep of section 2.1 runs in the body's own frame, so that a wall that moves
// onto the proxy pushes it and never passes it.
#pragma once

#include "core/base/vec.h"

namespace tactum {

struct BodyMotion {
    Pose before; ///< X_WB at the last step
    Pose now;    ///< X_WB at this step
    /// The body did not go from the one to the other but was put there: an animation that starts anew.
    bool jumped = false;

    /// The point of the world that the body's material carries p_W to. Thread: real time.
    Vec3 carried(const Vec3& p_W) const { return now.apply(before.applyInverse(p_W)); }
    /// How far the material that is now at p_W came in this step. Thread: real time.
    Vec3 wayOf(const Vec3& p_W) const {
        return jumped ? Vec3::Zero() : Vec3(p_W - before.apply(now.applyInverse(p_W)));
    }
    /// The pose on the way: 0 before, 1 now. Thread: real time.
    Pose between(double part) const {
        if (part >= 1) return now;
        return {before.rotation.slerp(part, now.rotation),
                before.translation + part * (now.translation - before.translation)};
    }
};

} // namespace tactum
