// Names one surface of a scene.
#pragma once

#include "core/scene/scene.h"

namespace tactum {

struct SurfaceRef {
    ObjectId object = 0;
    Index surface = 0; ///< index into the object's surfaces

    bool operator==(const SurfaceRef&) const = default;
};

} // namespace tactum
