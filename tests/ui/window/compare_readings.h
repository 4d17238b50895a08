// What other programs found in files of a scene, against the scene itself.
#pragma once

#include "core/scene/scene.h"
#include "tests/ui/window/other_readers.h"

namespace tactum::test {

/// Whether what is written shows bumps on a surface, as the view does.
bool hasBumps(const SceneObject& object, const Surface& surface);

/// Fails the running test where an object of a scene of the five models is elsewhere or looks otherwise in a
/// file.
void compareWith(const Scene& scene, const Readings& readings);

} // namespace tactum::test
