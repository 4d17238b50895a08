// Texture stacks as pictures for other programs: flattened once, small, and the look of a bump.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/files/flatten_layers.h"
#include "core/files/gltf/drawn_mesh.h"

namespace tactum {

/// A map is a copy for others, which must not make saving slow or files large. Texels
inline constexpr int kLargestMapSide = 192;

/// The maps of a scene's surfaces. Objects outlive it. Of no use after a cancel.
class SurfaceMaps {
public:
    explicit SurfaceMaps(const Progress& progress) : how_{kLargestMapSide, {{}, progress.cancelled}} {}

    /// As flattenHeight(); made once for surfaces of one object on which it is the same.
    const FlatPicture& height(const SceneObject& object, Index asked);
    FlatPicture felt(const SceneObject& object, Index surface, double Material::*value) const;
    /// The height as an RGB picture of normals in the frame of tangents: x along u, y along v upward. Empty
    /// where the height is the same everywhere.
    std::string normalsPng(const SceneObject& object, Index surface);

private:
    const Flattening how_;
    std::map<std::pair<const SceneObject*, Index>, FlatPicture> heights_;
};

/// Whether a map of normals can be shown: programs agree about its frame only where there are normals,
/// coordinates and tangents.
bool canShowBumps(const SceneObject& object);

/// Of each vertex: along u, orthogonal to the normal, and 1 or -1 for the side on which v rises.
std::vector<Eigen::Vector4f> tangentsOf(const DrawnMesh& mesh);

} // namespace tactum
