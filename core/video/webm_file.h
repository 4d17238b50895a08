// A video as WebM. For this folder only.
#pragma once

#include <memory>

#include "core/video/video_file.h"
#include "core/video/video_output.h"

namespace tactum {

Result<std::unique_ptr<VideoFile>> beginWebm(VideoOutput output, int width, int height);

} // namespace tactum
