// The small coordinate cross in the corner. Private to this folder.
#pragma once

#include "ui/base/theme.h"
#include "ui/view/view_camera.h"

class QPainter;

namespace tactum {

/// Draws the cross of the world's axes, with their letters, into the upper right corner.
void drawAxes(QPainter& painter, const ViewCamera& camera, const Theme& theme);

} // namespace tactum
