// The pictures of heights that a material library names, as texture layers. For this folder only.
#pragma once

#include <map>
#include <set>

#include "core/files/load_scene.h"
#include "core/files/mesh/read_mtl.h"

namespace tactum {

/// Reads each picture once, none that lies outside the model's folder, and no more than fit into memory.
class BumpLayers {
public:
    explicit BumpLayers(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// The layer of height that a bump map asks for. A material library has no unit: -bm 1 is taken as the
    /// height that a new layer begins with, kTextureHeight.initial, and the picture fills the unit square of
    /// the texture coordinates. What cannot be read becomes a finding and no layer.
    std::optional<TextureLayer> layerOf(const MtlBump& bump, std::vector<Finding>& findings);

private:
    using Image = std::shared_ptr<const TextureImage>;
    Image imageOf(const std::string& reference, std::vector<Finding>& findings);
    Image read(const std::string& reference, std::vector<Finding>& findings);

    std::filesystem::path folder_;
    std::size_t texels_ = 0;              ///< of all of them
    std::map<std::string, Image> images_; ///< empty where it could not be read
    std::set<std::string> said_;          ///< sentences of findings: one for all surfaces that it is true of
};

} // namespace tactum
