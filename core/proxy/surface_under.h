// What the surface under a contact has beyond its material, and what of its texture the felt planes need.
#pragma once

#include <array>

#include "core/proxy/contact.h"
#include "core/surface/texture_feel.h"

namespace tactum {

/// Nothing for a triangle that feels as it is. Thread: real time.
inline const SurfaceFeel* feelOf(const Obstacle& obstacle, Index triangle) noexcept {
    if (obstacle.feels.empty()) return nullptr;
    const SurfaceFeel& feel = obstacle.feels[obstacle.surfaceOf(triangle)];
    return feel.normals || feel.texture ? &feel : nullptr;
}

using FeltSlopes = std::array<Vec3, 1 + kMaxOwnPlanes>;

/// The slopes of all planes that a texture gives, and how many: at least one. Thread: real time.
int slopesOf(const TextureFeel& feel, FeltSlopes& slopes) noexcept;

} // namespace tactum
