// What a Wavefront material library says for the eye and for touch.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>

#include "core/base/vec.h"
#include "core/files/load_scene.h"
#include "core/files/source.h"

namespace tactum {

/// A picture of heights: `bump` or `map_bump`, with its -bm.
struct MtlBump {
    std::string file;      ///< as the library names it
    std::string where;     ///< file and line that say so
    double multiplier = 1; ///< -bm, finite
    bool placed = false;   ///< it has a -s, -o or -t that changes how the picture lies
};

/// What else the file says is skipped.
struct MtlMaterial {
    std::optional<Eigen::Vector3f> colour; ///< Kd
    std::optional<MtlBump> bump;
};
using MtlMaterials = std::unordered_map<std::string, MtlMaterial>;

/// Adds the materials of one library. A -bm that is no number becomes a finding. Throws ReadFault when the
/// file cannot be read at all.
void readMaterials(const std::filesystem::path& file, MtlMaterials& materials,
                   std::vector<Finding>& findings);

} // namespace tactum
