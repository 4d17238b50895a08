// Colours as a screen shows them, and as linear light, which scenes store and shaders reckon with.
#pragma once

#include <QColor>

#include "core/base/vec.h"

namespace tactum {

/// `linear`: red, green and blue, 0 to 1; what is beyond is shown as the nearest. By the curve of the view's
/// shaders, 2.2.
QColor screenColour(const Eigen::Vector3f& linear);
Eigen::Vector3f linearColour(const QColor& screen);

} // namespace tactum
