// The spheres of the collision hierarchy at one level, as triangles.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/haptics/world.h"

namespace tactum {

/// More are not drawn: of a level that has more, those nearest to a place.
inline constexpr std::size_t kMaxSpheres = 10'000;

/// The spheres of one object, as triangles.
struct SphereMesh {
    ObjectId object = 0;
    std::vector<float> positions, normals; ///< body frame
    std::vector<int> triangles;
};

struct SphereLevel {
    std::vector<SphereMesh> meshes;
    std::size_t all = 0, drawn = 0; ///< spheres
    int deepest = 0;                ///< level that shows only leaves
};

/// The spheres of a level in all visible bodies. Thread: any but real time.
SphereLevel sphereLevel(const World& world, int level, const Vec3& near_W, const Progress& progress = {});

} // namespace tactum
