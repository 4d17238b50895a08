// A picture of a replay: the scene with both paths on it, and the force over time beneath.
#pragma once

#include <filesystem>

#include <QSize>

#include "core/base/result.h"
#include "core/haptics/replay.h"
#include "core/scene/scene.h"

namespace tactum {

/// Draws and writes a PNG of `size` pixels, at least 320 x 240. Shows no window, but needs a QGuiApplication
/// made after useViewSurfaceFormat(), on a display with OpenGL (Xvfb will do).
/// Errors: an empty trace (input), no OpenGL or a file that cannot be written (machine). Thread: main.
Result<void> writeTouchPicture(const Scene& scene, const TouchTrace& rows, const std::filesystem::path& png,
                               QSize size);

} // namespace tactum
