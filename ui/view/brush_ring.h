// The rings of the brushes: on the model, and on the view. Private to this folder.
#pragma once

#include "ui/base/theme.h"
#include "ui/view/scene_picker.h"
#include "ui/view/scene_view.h"

class QPainter;

namespace tactum {

/// The circle of the brush in the plane of the triangle that it is over, and where it begins to fade.
void drawBrushRing(QPainter& painter, const PickHit& at, const BrushRing& ring, const ViewCamera& camera,
                   const Theme& theme);

/// The ring of the select tool's brush about a place of the view, logical pixels.
void drawSelectBrush(QPainter& painter, QPointF at, double radius, const Theme& theme);

} // namespace tactum
