// What is taken out of the JSON of a glTF file before anything of it is read.
#pragma once

#include "core/files/gltf/gltf_file.h"

namespace tactum {

/// Animations that have another form than glTF gives them, for nobody looks at that again. How many.
std::size_t eraseDamagedAnimations(Json& root);

/// The copies that Draco packed of meshes that are there as they are as well, so that nobody takes their data
/// for that of something unknown.
void erasePackedCopies(Json& root);

} // namespace tactum
