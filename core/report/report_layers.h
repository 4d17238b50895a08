// The part of a report about layers of texture. For this folder only.
#pragma once

#include <string>

#include "core/scene/describe.h"
#include "core/scene/scene.h"

namespace tactum {

/// For each object with layers its picture, and each layer with its own; empty where there are none.
/// `described`: of the same scene.
std::string layersSection(const Scene& scene, const SceneDescription& described);

} // namespace tactum
