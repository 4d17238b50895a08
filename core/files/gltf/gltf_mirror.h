// The feel in `extras`, as plain numbers and words. Programs that drop unknown extensions keep these, and
// Blender shows them as custom properties. A copy: where our extension is, it alone counts.
#pragma once

#include "core/files/gltf/gltf_file.h"

namespace tactum {

/// Where they are, in sentences.
inline constexpr const char* kMirror = "extras";

/// Writes the numbers and words of our extension of an element into its extras: "staticFriction" as
/// "tactum_static_friction"; layers as one text, without what lies elsewhere in the file. Extras that are no
/// object stay as they are.
void addMirror(Json& element, const Json& ours);

/// Takes it away again. What other programs have in extras stays.
void eraseMirror(Json& element);

/// What is mirrored, in the form of our extension; an empty object where nothing is.
Json mirrored(const Json& element);

} // namespace tactum
