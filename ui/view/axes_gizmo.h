// The small coordinate cross in the corner. Private to this folder.
#pragma once

#include <optional>

#include <QRegion>

#include "ui/base/theme.h"
#include "ui/view/view_camera.h"

class QPainter;

namespace tactum {

/// Where the cross is in a view of that size: in its upper right corner, or below what covers that; in the
/// corner again where nothing is free. Logical pixels.
QRectF axesPlace(QSizeF view, const QRegion& covered);
/// Whether there is one: a small pane of several has no room for it.
bool hasAxes(QSizeF pane, bool divided);
/// The end of an axis that is drawn at a place of the view, the foremost one; nothing where none is. A unit
/// vector of the world frame.
std::optional<Vec3> axisAt(QPointF place, const ViewCamera& camera, const QRegion& covered);
/// Draws the cross of the world's axes, with their letters.
void drawAxes(QPainter& painter, const ViewCamera& camera, const Theme& theme, const QRegion& covered = {});

} // namespace tactum
