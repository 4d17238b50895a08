// The ring of the brush on the model. Private to this folder.
#pragma once

#include "ui/theme.h"
#include "ui/view/scene_picker.h"
#include "ui/view/scene_view.h"

class QPainter;

namespace tactum {

/// The circle of the brush in the plane of the triangle that it is over, and where it begins to fade.
void drawBrushRing(QPainter& painter, const PickHit& at, const BrushRing& ring, const ViewCamera& camera,
                   const Theme& theme);

} // namespace tactum
