// What is taken out of the JSON of a glTF file before anything of it is read.
#pragma once

#include "core/files/gltf/gltf_file.h"

namespace tactum {

/// Animations that have another form than glTF gives them, for nobody looks at that again. How many.
std::size_t eraseDamagedAnimations(Json& root);

} // namespace tactum
