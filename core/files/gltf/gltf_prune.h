// The data of meshes that became objects, taken out of what is kept of a glTF file.
#pragma once

#include <string>

#include "core/files/gltf/gltf_file.h"

namespace tactum {

/// Drops meshes that no node names any more, with their accessors, buffer views and bytes; what else uses
/// data keeps it under new indices. Leaves a file as it is whose skins or whose extensions might name data in
/// ways that are not known here. `root`: views refer to one buffer, which is `binary`.
void pruneMeshData(Json& root, std::string& binary);

} // namespace tactum
