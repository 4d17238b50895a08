// Cameras as scenes keep them, and where the view looks from.
#pragma once

#include <string>

#include "core/scene/saved_cameras.h"
#include "ui/view/view_camera.h"

namespace tactum {

SavedCamera savedCamera(const ViewCamera& camera, std::string name);
/// In a view of the same size it shows what the saved camera sees; one that is tilted to a side is upright
/// here. `like`: of which it takes the size and, where the projection is parallel, the field of view.
ViewCamera viewOf(const SavedCamera& saved, const ViewCamera& like);

} // namespace tactum
