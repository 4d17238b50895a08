// The page of a bundle for whoever opens the zip without Tactum. For this folder only.
#pragma once

#include <string>

#include "core/haptics/replay.h"
#include "core/scene/scene.h"

namespace tactum {

/// What lies in the bundle, in which units, and how to hold another renderer against it.
std::string bundleReadme(const Scene& scene, const TouchTrace& rows);

/// A number with as few digits as read back as the same.
std::string shortest(double value);

/// Whether any step of a replay touched anything.
bool touchesAnything(const TouchTrace& rows);
/// N, before any device's limit.
double largestForceOf(const TouchTrace& rows);

} // namespace tactum
