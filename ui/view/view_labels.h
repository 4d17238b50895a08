// Words in the view: the force, stick or slip, and which sphere is which. Private to this folder.
#pragma once

#include <QFont>

#include "ui/base/theme.h"
#include "ui/view/touch_overlay.h"
#include "ui/view/view_camera.h"

class QPainter;

namespace tactum {

/// Which hand it is of several.
struct HandName {
    std::size_t number = 0;
    QString name; ///< empty: it is the only one
};

/// Draws the labels of a touch beside what they name, in logical pixels. `touched`: the name of the surface;
/// may be empty.
void drawTouchLabels(QPainter& painter, const TouchState& state, const ViewCamera& camera, const Theme& theme,
                     const QString& touched = {}, const HandName& hand = {});
/// Of a hand beside that one: its name and its force.
void drawHandLabels(QPainter& painter, const TouchState& state, const ViewCamera& camera, const Theme& theme,
                    const HandName& hand);

} // namespace tactum
