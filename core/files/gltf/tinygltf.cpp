// tinygltf itself, compiled once, in the namespace that gltf_model.h gives it.
#include "core/files/gltf/gltf_file.h"

#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_INCLUDE_JSON
#include "core/files/gltf/gltf_model.h"
