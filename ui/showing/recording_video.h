// A recording as a video, without a person.
#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/recording/player.h"

namespace tactum {

struct RecordingVideo {
    std::filesystem::path file; ///< its ending says what it becomes, see beginVideo()
    int height = 720;           ///< pixels, of 16:9
    bool plot = false;          ///< the force plot beneath the view
};

/// Thirty pictures a second at the recording's own times, however long each of them takes to draw: the view
/// that the window shows of it, from where a scene is seen first. Cancelled, the video is complete up to
/// there. Needs a QApplication made after useViewSurfaceFormat(), on a display with OpenGL. Returns how much
/// of the recording is in the video, s. Errors: those of a VideoFile. Thread: main.
Result<double> writeRecordingVideo(Player player, const RecordingVideo& what, const Progress& progress = {});

} // namespace tactum
