// What was painted on a mesh, for another form of the same mesh.
#pragma once

#include <memory>

#include "core/geometry/triangle_soup.h"
#include "core/surface/painted_values.h"

namespace tactum {

/// The values of `before` for the positions of `after`, a repaired or welded form of it: with as many
/// positions they keep their order; else each takes the value of where it was, or of the nearest place within
/// a hundred-thousandth of the diagonal, the mean where several lie there, and 0 where nothing was. Null
/// stays null. Thread: any but real time; a second for a million positions.
std::shared_ptr<const PaintedValues> carriedPaint(const std::shared_ptr<const PaintedValues>& values,
                                                  const TriangleSoup& before, const TriangleSoup& after);

} // namespace tactum
