// What tells the panes of a divided view apart: their names, and a frame about the active one. Private to
// this folder.
#pragma once

#include <QRegion>
#include <QString>

#include "ui/base/theme.h"
#include "ui/view/view_camera.h"

class QPainter;

namespace tactum {

/// By where it looks from: "Front, parallel". A pane that has been turned is called after where it did at
/// first, as ViewPanes numbers them.
QString paneName(std::size_t pane, const ViewCamera& camera);
/// In the upper left corner, below what covers it; gives how far down it reaches. The painter's origin is the
/// pane's corner; logical pixels.
double drawPaneName(QPainter& painter, const QString& whole, const QSizeF& pane, const Theme& theme,
                    bool active, const QRegion& covered);
void drawPaneFrame(QPainter& painter, const QSizeF& size, const Theme& theme);

} // namespace tactum
