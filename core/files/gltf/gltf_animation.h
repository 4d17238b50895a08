// A body's motion in a glTF file: an animation for every program, and its exact numbers for ours.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/files/gltf/gltf_data.h"
#include "core/motion/motion.h"

namespace tactum {

/// Appends an animation of one node that makes the motion relative to its parent; nothing for one without
/// keys.
void addAnimation(GltfData& data, const Motion& motion, int node, const std::string& name);

/// The motion exactly, under the key "motion" of our extension of a node.
Json motionJson(const Motion& motion);
/// Nothing where the JSON is not one that motionJson() could have written.
std::optional<Motion> motionOf(const Json& json);

} // namespace tactum
