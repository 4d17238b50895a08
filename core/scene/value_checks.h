// Findings about the numbers of a scene and about its texture layers. For this folder only.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/scene/findings.h"

namespace tactum {

/// Six digits at most, with the unit if there is one.
std::string withUnit(double value, std::string_view unit);

/// A number that means nothing is an error; one beyond the range is clamped when touched. `of` goes on the
/// parameter's label: " of surface \"lid\"".
void checkParameter(std::vector<Finding>& findings, const std::string& object, const std::string& of,
                    const Parameter& parameter, double value);

/// Layers that cannot be felt, or not as their numbers say.
void checkTextures(std::vector<Finding>& findings, const SceneObject& object);

} // namespace tactum
