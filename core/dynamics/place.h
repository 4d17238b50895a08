// A frame that moves with a link. For this folder.
#pragma once

#include "core/base/vec.h"

namespace tactum {

/// A frame that moves with a link.
struct Place {
    int link = -1; ///< -1: it stands still in the world
    Pose pose;     ///< link frame, or world
};

} // namespace tactum
