// The colour of a surface as a small square.
#pragma once

#include <QIcon>
#include <QPixmap>

#include "core/base/vec.h"

namespace tactum {

/// The colour as a small square. `linear`: RGB as scenes store it, 0 to 1.
QPixmap swatch(const Eigen::Vector3f& linear);
/// The same for a row of a list, in the same colour while the row is selected.
QIcon swatchIcon(const Eigen::Vector3f& linear);

} // namespace tactum
