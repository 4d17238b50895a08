// Bodies, joints and colliders of KHR_physics_rigid_bodies with KHR_implicit_shapes, as their draft of
// October 2025 has them, and geometry.mesh, which came after it.
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "core/dynamics/mechanics.h"
#include "core/files/gltf/gltf_model.h"
#include "core/files/gltf/gltf_motion.h"
#include "core/scene/findings.h"

namespace tactum {

/// The corners and triangles of a mesh of the file.
using ReadShapeMesh = std::function<ShapeMesh(int mesh)>;

struct GltfPhysics {
    Mechanics mechanics;
    std::map<int, BodyId> bodyOfNode; ///< of every node at or below one with a motion
    std::vector<Finding> findings;
};

/// Of the nodes of the scene that is shown, at the time 0; what the draft leaves to the program is said in
/// docs/format.md. Throws ReadFault.
GltfPhysics readPhysics(const Source& source, const tinygltf::Model& model, const Json& root,
                        const GltfMotions& motions, const ReadShapeMesh& meshAt);

} // namespace tactum
