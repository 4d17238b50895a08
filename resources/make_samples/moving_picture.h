// A scene that is touched by its own finger, as a moving picture.
#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace tactum::samples {

/// GIF of 224 x 168 pixels, twelve and a half pictures a second: a stylus at the proxy while the finger goes
/// along its path, and the bodies where it has pushed them. The same scene gives the same bytes.
Result<void> writeMovingPicture(const Scene& scene, const std::filesystem::path& file);

} // namespace tactum::samples
