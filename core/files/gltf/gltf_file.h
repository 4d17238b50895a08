// The container of glTF: JSON and one binary chunk, taken apart with every length checked, and put together.
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "core/files/source.h"

namespace tactum {

using Json = nlohmann::json;

/// A glTF or glb file as it stands, its JSON whole: an object of at most 128 levels.
struct GltfFile {
    Json json;
    std::string_view binary; ///< the second chunk of a glb, inside the bytes of the source
    bool isBinary = false;
};

/// Takes a file apart; the lengths of a glb must add up to that of the file. Throws ReadFault.
GltfFile openGltf(const Source& source);

/// A glb of this JSON and binary chunk; below 4 GiB, which the caller sees to.
std::string packGlb(const Json& json, std::string_view binary);

} // namespace tactum
