// Which elements of a glTF file name which others: what has to follow when elements change their places.
#pragma once

#include <array>
#include <functional>

#include "core/files/gltf/gltf_file.h"

namespace tactum {

/// Every array of the format's root.
inline constexpr std::array<const char*, 13> kGltfArrays{
    "accessors", "animations", "buffers",  "bufferViews", "cameras", "images",  "materials",
    "meshes",    "nodes",      "samplers", "scenes",      "skins",   "textures"};

/// An array of a root, or null.
Json* arrayIn(Json& root, const char* key);

/// What names an element: `Holds` cannot be without it, `Lists` is a list of nodes that can be shorter.
enum class Naming { Holds, Lists };
/// `index`: a whole number from zero on, to be looked at or changed; null takes it out of a list.
using VisitReference = std::function<void(const char* array, Json& index, Naming naming)>;

/// Visits all indices in an element of `array`: those of the format itself, of our own extension, and of the
/// extensions that followsReferences() knows. Not those of bufferViews, which all name the one buffer.
void visitReferences(const char* array, Json& element, const VisitReference& visit);
/// The same for the extensions of the root.
void visitRootReferences(Json& root, const VisitReference& visit);

/// Whether all indices in an extension are visited, or it has none.
bool followsReferences(const std::string& extension);

} // namespace tactum
