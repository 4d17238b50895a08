// Names one surface of a scene.
#pragma once

#include <vector>

#include "core/scene/scene.h"

namespace tactum {

struct SurfaceRef {
    ObjectId object = 0;
    Index surface = 0; ///< index into the object's surfaces

    bool operator==(const SurfaceRef&) const = default;
};

/// All surfaces of the scene that feel as this one does: same material, shading, layers and sides, whatever
/// their names and colours. Itself is among them; none for a reference to nothing. Thread: any but real time.
std::vector<SurfaceRef> surfacesLike(const Scene& scene, SurfaceRef ref);

} // namespace tactum
