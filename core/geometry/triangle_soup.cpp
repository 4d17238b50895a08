#include "core/geometry/triangle_soup.h"

namespace tactum {

Bounds boundsOf(const TriangleSoup& soup) {
    Bounds box;
    for (const auto& triangle : soup.triangles)
        for (Index corner : triangle)
            box.add(soup.positions[corner]);
    return box;
}

bool haveSameShape(const TriangleSoup& a, const TriangleSoup& b) {
    return &a == &b ||
           (a.triangles == b.triangles && a.positions == b.positions && a.cornerNormals == b.cornerNormals);
}

} // namespace tactum
