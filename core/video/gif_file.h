// A video as GIF. For this folder only.
#pragma once

#include <memory>

#include "core/video/video_file.h"
#include "core/video/video_output.h"

namespace tactum {

/// It begins anew at its end, for ever.
Result<std::unique_ptr<VideoFile>> beginGif(VideoOutput output, int width, int height);

} // namespace tactum
