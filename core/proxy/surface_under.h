// What the surface under a contact has beyond its material: the normals that it is felt with there, and how
// it rubs.
#pragma once

#include "core/base/inplace_vector.h"
#include "core/proxy/felt_foot.h"
#include "core/surface/texture_feel.h"

namespace tactum {

/// Nothing for a triangle that feels as it is. Thread: real time.
inline const SurfaceFeel* feelOf(const Obstacle& obstacle, Index triangle) noexcept {
    if (obstacle.feels.empty()) return nullptr;
    const SurfaceFeel& feel = obstacle.feels[obstacle.surfaceOf(triangle)];
    return feel.normals || feel.texture ? &feel : nullptr;
}

/// How finely a texture is felt: what is smaller than `smallestFeature`, m, is not; what is painted is
/// filtered along `passing`, the way in which such a feature passes, m, body frame.
struct Fineness {
    double smallestFeature = 0;
    Vec3 passing = Vec3::Zero();
};

/// Of the planes that a surface is felt with at one place: the texture's, and those that layers add. Body
/// frame, unit length.
using FeltNormals = InplaceVector<Vec3, 1 + kMaxOwnPlanes>;

/// The normals that the surface under a foot is felt with. `away`: the true one there; `material` becomes
/// what its layers make of it. Body frame. Thread: real time.
FeltNormals feltNormals(const Obstacle& obstacle, const SurfaceFeel& feel, const Foot& foot, const Vec3& away,
                        const Fineness& fineness, Material& material) noexcept;

/// What its layers make of the material under a foot, where no normal is asked for. Thread: real time.
void rubAsFelt(const Obstacle& obstacle, const SurfaceFeel& feel, const Foot& foot, const Vec3& away,
               const Fineness& fineness, Material& material) noexcept;

} // namespace tactum
