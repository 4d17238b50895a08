// What a handle does beside going to places: it is turned, and pressed together. Carried between device and
// servo; nothing feels it yet.
#pragma once

#include "core/base/vec.h"

namespace tactum {

/// Frame D.
struct HandleReading {
    Quat orientation = Quat::Identity(); ///< from the handle's own axes to D
    double opening = 0;                  ///< m, how far a gripper is open
    bool turns = false, grips = false;   ///< whether the device has measured each
};

/// Frame D.
struct HandleCommand {
    Vec3 torque = Vec3::Zero(); ///< N m, on the handle
    double pinch = 0;           ///< N, that opens the gripper; below 0 it closes it
};

} // namespace tactum
