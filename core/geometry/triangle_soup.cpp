#include "core/geometry/triangle_soup.h"

namespace tactum {

Bounds boundsOf(const TriangleSoup& soup) {
    Bounds box;
    for (const auto& triangle : soup.triangles)
        for (Index corner : triangle)
            box.add(soup.positions[corner]);
    return box;
}

} // namespace tactum
