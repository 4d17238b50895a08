// Meshes that KHR_draco_mesh_compression, EXT_ or KHR_meshopt_compression made small, as the arrays that they
// were.
#pragma once

#include "core/files/gltf/gltf_model.h"

namespace tactum {

/// Lets everything that is packed be its packed bytes, and what stands in for it be next to nothing: for a
/// parser that knows nothing of it, and for nobody else. `isBinary`: the first buffer is that of a glb.
void pointAtPacked(Json& root, bool isBinary);

/// Unpacks all that is packed, in buffers that are added to the model and to the root, and takes away from
/// the root what tells of it. Of a mesh that is there as it is as well nothing is unpacked. Throws ReadFault.
void unpackMeshes(const Source& source, Json& root, tinygltf::Model& model);

} // namespace tactum
