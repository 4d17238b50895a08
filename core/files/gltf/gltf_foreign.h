// The parts of a glTF file that are not ours: taken out of a file that is read, and put into one that is
// written.
#pragma once

#include <memory>
#include <vector>

#include "core/files/gltf/gltf_model.h"
#include "core/files/gltf/gltf_parting.h"
#include "core/scene/scene.h"

namespace tactum {

/// The root to write into: the foreign parts, or an empty one.
Json foreignRoot(const Scene& scene);

/// How many elements each array of a root has; 0 for one that is not there.
Json arrayCounts(const Json& root);

/// How rough and metallic a surface is of which no file said so.
Json usualLook();

/// Of a material that stood in another file what needs nothing else of that: its name and its look in
/// numbers.
Json lookAlone(const Json& material);

/// The nodes of a root that is being written.
class ForeignTree {
public:
    explicit ForeignTree(Json& root);
    /// Takes a node out of the tree: no node and no scene names it, it has no transform of its own any more.
    /// Its children stay where they were in the world, given that the node will be at `pose`.
    void uproot(int node, const Pose& pose);

private:
    Eigen::Affine3d worldOf(int node) const;
    bool isAnimated(int node) const;

    Json& root_;
    std::vector<int> parent_; ///< -1 for none
};

/// What is to be kept of a file: all of it that is not ours, in one binary chunk with its images. Null where
/// nothing is left. `missing`: gets the images that are not there. `idleMeshes`: how many meshes stay in it
/// that no node shows any more. Throws ReadFault.
std::shared_ptr<const ForeignGltf> foreignOf(const Source& source, const GltfFile& file,
                                             const tinygltf::Model& model, const GltfParting& parting,
                                             std::vector<std::string>& missing, std::size_t& idleMeshes);

/// The bytes of an image of the file: of its buffer view, of a data URI, or of a file in its folder. Empty
/// for none.
std::string imageBytes(const Source& source, const Json& image, const tinygltf::Model& model);

} // namespace tactum
