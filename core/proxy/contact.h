// What the proxy meets: meshes where they are, and the primitives that it touches.
#pragma once

#include <cstdint>
#include <span>

#include "core/base/vec.h"
#include "core/collision/sweep_memory.h"
#include "core/motion/movers.h"
#include "core/surface/material.h"
#include "core/surface/smooth_normals.h"
#include "core/surface/texture_stack.h"

namespace tactum {

/// What a surface has beyond its material; nothing for most.
struct SurfaceFeel {
    const SmoothNormals* normals = nullptr; ///< of force shading
    const TextureStack* texture = nullptr;
};

/// A mesh where it is now, with the feel of its surfaces.
struct Obstacle {
    const CollisionMesh* mesh = nullptr;
    Pose pose{}; ///< X_WB; of a body that moves by itself, at the time 0
    std::span<const Material> materials{};
    std::span<const SurfaceFeel> feels{}; ///< as many, or none when all surfaces are plain
    std::span<const Sides> sides{};       ///< as many, or none when all are felt from both sides
    int mover = -1;                       ///< which of the moving bodies it is; -1: it is at rest
    std::uint64_t placedIn = 0;           ///< World::shapeRevision in which it came to where it is

    Triangle triangle(Index index) const; ///< body frame
    /// Which surface a triangle belongs to. Most objects have one alone, and it is known without a look into
    /// memory that nothing else asks for.
    Index surfaceOf(Index index) const { return materials.size() == 1 ? 0 : mesh->soup->surfaceOf[index]; }
    const Material& material(Index index) const { return materials[surfaceOf(index)]; }
};

/// A primitive that the proxy touches, with its constraint plane. World frame.
struct Contact {
    std::uint32_t body = 0; ///< index of the obstacle
    Index triangle = 0;
    bool slipping = false;
    Vec3 point = Vec3::Zero();   ///< on the surface
    Vec3 normal = Vec3::UnitZ(); ///< out of the surface toward the proxy
    double gap = 0;              ///< from the proxy's surface to `point`, m; as low as -kSkin r
    double bend = 0;             ///< curvature of the C-obstacle, 1/m: 0 over a face
    Vec3 edge = Vec3::Zero();    ///< along which it does not bend: unit length on an edge, zero on a vertex
    double lambda = 0;           ///< multiplier of the plane, m: its force is k lambda normal (19)
    Material material;           ///< that it was last pushed with: the surface's, changed by its texture
};

/// Where an obstacle is at this step. Thread: real time.
inline Pose poseNow(const Obstacle& obstacle, const StepMotions& movers) noexcept {
    return obstacle.mover < 0 ? obstacle.pose : movers.of(obstacle.mover).now;
}

/// Finds the contact's constraint plane for a proxy of `radius` at `centre_W`, with how the C-obstacle bends
/// there: around an edge it is a cylinder, around a vertex a sphere. The contact's body and triangle say of
/// what. Thread: real time.
void locate(Contact& contact, std::span<const Obstacle> obstacles, const StepMotions& movers, double radius,
            const Vec3& centre_W) noexcept;

} // namespace tactum
