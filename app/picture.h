// What is drawn by Qt and stands apart from the other verbs: the picture of a replay, the video of a
// recording (both need a display, a virtual one will do), and the report of a scene.
#pragma once

#include <filesystem>
#include <memory>

#include "app/commands.h"
#include "core/base/result.h"
#include "core/haptics/replay.h"
#include "core/runtime/recorded_run.h"
#include "core/scene/scene.h"

namespace tactum {

/// Draws scene, finger path, proxy path and force plot into a PNG.
Result<void> writePicture(const Scene& scene, const TouchTrace& rows, const std::filesystem::path& file);
/// Draws a recording into a video, `height` pixels of 16:9. Ctrl+C ends the video, and then the program.
Result<void> writeVideo(const std::shared_ptr<const RecordedRun>& run, const std::filesystem::path& file,
                        int height, bool plot);

/// The report of a scene, as HTML or PDF. Needs no display.
Result<int> runReport(const ReportOptions& options);

} // namespace tactum
