// What compile() makes of a Scene: all the loops read and nothing they change. Shared, immutable.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/collision/collision_mesh.h"
#include "core/proxy/proxy.h"
#include "core/scene/scene.h"
#include "core/surface/material.h"

namespace tactum {

struct WorldBody {
    ObjectId object = 0;
    std::shared_ptr<const CollisionMesh> mesh;
    std::vector<Material> materials; ///< one for each surface of the object
};

/// Never copied after compile(): obstacles point into bodies.
struct World {
    std::vector<WorldBody> bodies;
    std::vector<Obstacle> obstacles; ///< one for each body, in the same order
    double proxyRadius = 0;          ///< m
    std::uint64_t revision = 0;      ///< rises with every compile
    /// Another number when a mesh, a pose or the proxy radius changed: contacts are void.
    std::uint64_t shapeRevision = 0;
};

} // namespace tactum
