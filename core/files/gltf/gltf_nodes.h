// The node tree of a glTF file as placed meshes.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/files/gltf/gltf_model.h"
#include "core/motion/motion.h"

namespace tactum {

class GltfMotions;

/// A mesh of such a node is there many times: a glTF of trees or screws.
inline constexpr const char* kInstancing = "EXT_mesh_gpu_instancing";

/// One mesh at one place: p_W = pose.apply(stretch * p + offset), p as in the file.
struct PlacedMesh {
    std::string name; ///< of the node, or of the mesh
    int node = 0, mesh = 0;
    std::optional<Pose> rest; ///< of the node above, if none above moves or has a scale: where our files put
                              ///< the pose of one that moves
    Pose pose;
    Mat3 stretch = Mat3::Identity(); ///< scale, shear and mirroring; exactly the identity where there is none
    Vec3 offset = Vec3::Zero();      ///< m; of a mesh below the node that moves, which is the body's frame
    std::shared_ptr<const Motion> motion; ///< relative to pose; null for a mesh at rest
    bool bends = false;                   ///< an animation also scales or shears it, which is left out
    bool deforms = false;                 ///< it has a skin or morph targets, which are left out
};

/// The meshes of the default scene, of the first, or of all root nodes where there is no scene. The tree must
/// have no cycle, no node with two parents and at most 64 levels. A mesh that moves, or whose ancestor does,
/// is where it is at the time 0. Every node has a place but those of cameras, with nothing else below. Throws
/// ReadFault.
std::vector<PlacedMesh> placedMeshes(const Source& source, const tinygltf::Model& model,
                                     const GltfMotions& motions);

/// The root nodes of the scene that is shown.
std::vector<int> sceneRoots(const tinygltf::Model& model);

/// The transform of one node to the world at the time 0, by that of its parent. Throws ReadFault where it has
/// none, or one beyond 1e6 m.
Eigen::Affine3d standingAt(const Source& source, const GltfMotions& motions, int node,
                           const Eigen::Affine3d& parent);
/// The same, or nothing: of a camera, see placedMeshes().
std::optional<Eigen::Affine3d> placeIfAny(const Source& source, const GltfMotions& motions, int node,
                                          const Eigen::Affine3d& parent);
/// The transform of one node to its parent, as it stands in the file. Throws ReadFault.
Eigen::Affine3d transformOf(const Source& source, const tinygltf::Model& model, int node);
/// Whether a rotation cannot be taken as it is: its length is further from 1 than rounding the components to
/// signed bytes, the coarsest that glTF allows, can bring it: 1/127, from half of that in each of the four.
bool needsUnitLength(const QuatCoefficients& rotation);
/// A rotation can be made of it: a length that is neither next to zero nor infinite.
bool isUsable(const QuatCoefficients& rotation);
/// Its translation and rotation, and its scale, for a node that gives them apart. Throws ReadFault.
Pose rigidOf(const Source& source, const tinygltf::Model& model, int node);
Eigen::AlignedScaling3d scaleOf(const tinygltf::Model& model, int node);

/// A = R S with R a rotation (no mirror) and S symmetric but for a mirror: R goes to the pose.
struct RigidAndStretch {
    Mat3 rotation, stretch;
};
RigidAndStretch polarDecomposition(const Mat3& a);

} // namespace tactum
