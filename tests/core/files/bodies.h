// An object around a soup, everything else as it begins.
#pragma once

#include "core/scene/scene.h"

namespace tactum::test {

/// With one surface.
inline SceneObject bodyOf(std::string name, std::shared_ptr<const TriangleSoup> soup) {
    SceneObject object;
    object.name = std::move(name);
    object.geometry = std::move(soup);
    object.surfaces.resize(1);
    return object;
}

} // namespace tactum::test
