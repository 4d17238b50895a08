// The force of a replay over its time, as a plot. Private to this folder.
#pragma once

#include <QRectF>

#include "core/haptics/replay.h"
#include "ui/base/theme.h"

class QPainter;

namespace tactum {

/// Draws |F| over t with axes, units and the spans of contact. The trace must not be empty.
void drawForcePlot(QPainter& painter, const QRectF& box, const TouchTrace& rows, const Theme& theme);

} // namespace tactum
