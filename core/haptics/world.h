// What compile() makes of a Scene: all the loops read and nothing they change. Shared, immutable.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/collision/collision_mesh.h"
#include "core/haptics/degradation.h"
#include "core/haptics/moving_bodies.h"
#include "core/motion/motion.h"
#include "core/proxy/near_bodies.h"
#include "core/proxy/proxy.h"
#include "core/scene/scene.h"
#include "core/surface/material.h"

namespace tactum {

struct WorldBody {
    ObjectId object = 0;
    std::shared_ptr<const CollisionMesh> mesh;
    std::vector<Material> materials; ///< one for each surface of the object
    // As many, or none when no surface is shaded or textured; `feels` points into the other two.
    std::vector<std::shared_ptr<const SmoothNormals>> normals;
    std::vector<std::shared_ptr<const TextureStack>> textures;
    std::vector<SurfaceFeel> feels;
    std::vector<SurfaceFeel> feelsWithoutTexture; ///< likewise, none when no surface is shaded
    std::vector<Sides> sides; ///< as many, or none when all surfaces are felt from both sides
};

/// What a World owes to the ones before it instead of to its scene.
struct WorldNumbers {
    std::uint64_t revision = 0, shapeRevision = 0;
    std::vector<std::uint64_t> placedIn; ///< of each obstacle
};

/// Never copied after compile(): obstacles point into bodies.
struct World {
    std::vector<WorldBody> bodies;
    std::vector<Obstacle> obstacles;         ///< one for each body, in the same order
    std::vector<Obstacle> untextured, plain; ///< the same, with less to feel: see Fidelity
    std::vector<Mover> movers;               ///< Obstacle::mover is an index into them
    NearBodies near;                         ///< of all three
    /// What forces move; null: nothing. Its memory is written by each step: only one thread steps a World.
    std::unique_ptr<MovingBodies> moving;
    double proxyRadius = 0;             ///< m
    std::shared_ptr<const Scene> scene; ///< what it was made of
    std::uint64_t revision = 0;         ///< rises with every compile
    /// Another number when a mesh, a pose, a motion or the proxy radius changed: contacts are void.
    std::uint64_t shapeRevision = 0;

    std::span<const BodyMotion> drivenMotions() const noexcept {
        return moving ? moving->motions() : std::span<const BodyMotion>{};
    }
    const std::vector<Obstacle>& obstaclesAt(Fidelity fidelity) const noexcept {
        if (fidelity == Fidelity::Full) return obstacles;
        return fidelity == Fidelity::NoTexture ? untextured : plain;
    }
};

} // namespace tactum
