// The picture of a replay: needs a display (a virtual one will do), so it stands apart from the other verbs.
#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/haptics/replay.h"
#include "core/scene/scene.h"

namespace tactum {

/// Draws scene, finger path, proxy path and force plot into a PNG.
Result<void> writePicture(const Scene& scene, const TouchTrace& rows, const std::filesystem::path& file);

} // namespace tactum
