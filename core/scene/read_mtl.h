// The colours of a Wavefront material library.
#pragma once

#include <string>
#include <unordered_map>

#include "core/base/vec.h"
#include "core/scene/source.h"

namespace tactum {

/// Diffuse colour (Kd) of each material. What else the file says, or says wrongly, is skipped: it is for the
/// eye.
using MaterialColours = std::unordered_map<std::string, Eigen::Vector3f>;

/// Adds the colours of one library. Throws ReadFault when the file cannot be read at all.
void readMaterialColours(const std::filesystem::path& file, MaterialColours& colours);

} // namespace tactum
