// The cameras of a glTF file as saved cameras of the scene, and these again as cameras and nodes.
#pragma once

#include <string>
#include <vector>

#include "core/files/gltf/gltf_motion.h"
#include "core/scene/saved_cameras.h"

namespace tactum {

/// What our extension of a node says it was made for.
inline constexpr const char* kCameraRole = "camera";

/// One that was read. `camera.ahead` is 0 where the file does not say it.
struct PlacedCamera {
    SavedCamera camera;
    int node = 0, index = 0; ///< in the file
};

/// Those of the scene that is shown, where they stand; one on a node with a mesh, on one that moves or on one
/// below that stays with whoever put it there. One that is damaged is left out, which `findings` tells. The
/// tree is one that placedMeshes() has taken.
std::vector<PlacedCamera> placedCameras(const Source& source, const tinygltf::Model& model, const Json& root,
                                        const GltfMotions& motions, std::vector<Finding>& findings);

/// The element of the array "cameras", over what was kept of it.
Json cameraJson(const SavedCamera& camera);
/// The members of its node, but for the place of the camera.
Json cameraNodeJson(const SavedCamera& camera);

} // namespace tactum
