// What the haptic loop needs of one object's geometry: its triangles and the sphere tree over them.
#pragma once

#include <memory>

#include "core/collision/sphere_tree.h"
#include "core/geometry/triangle_soup.h"

namespace tactum {

/// Immutable; shared between worlds so that an edit of a surface rebuilds nothing.
struct CollisionMesh {
    std::shared_ptr<const TriangleSoup> soup;
    SphereTree tree;
    bool closed = false; ///< its triangles have an inside, and their front is outside (isClosed)
};

} // namespace tactum
