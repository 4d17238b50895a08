// The node tree of a glTF file as placed meshes.
#pragma once

#include <vector>

#include "core/scene/gltf_model.h"

namespace tactum {

/// One mesh at one place: p_W = pose.apply(stretch * p), p as in the file.
struct PlacedMesh {
    std::string name; ///< of the node, or of the mesh
    int mesh = 0;
    Pose pose;
    Mat3 stretch = Mat3::Identity(); ///< scale, shear and mirroring; exactly the identity where there is none
};

/// The meshes of the default scene, of the first, or of all root nodes where there is no scene. The tree must
/// have no cycle, no node with two parents and at most 64 levels. Throws ReadFault.
std::vector<PlacedMesh> placedMeshes(const Source& source, const tinygltf::Model& model);

/// A = R S with R a rotation (no mirror) and S symmetric but for a mirror: R goes to the pose.
struct RigidAndStretch {
    Mat3 rotation, stretch;
};
RigidAndStretch polarDecomposition(const Mat3& a);

} // namespace tactum
