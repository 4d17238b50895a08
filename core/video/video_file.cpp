#include "core/video/video_file.h"

#include <cassert>

#include "core/base/text.h"
#include "core/video/gif_file.h"
#include "core/video/video_output.h"
#include "core/video/webm_file.h"

namespace tactum {

namespace {

bool ends(const std::filesystem::path& file, const char* ending) {
    return lowerCase(file.extension().string()) == std::string(".") + ending;
}

} // namespace

Result<void> checkVideoFile(const std::filesystem::path& file) {
    if (ends(file, kWebmEnding) || ends(file, kGifEnding)) return {};
    return inputError(printable(file.string(), 200) +
                      ": a video is written as .webm or .gif; choose one of them");
}

Result<std::unique_ptr<VideoFile>> beginVideo(const std::filesystem::path& file, int width, int height) {
    assert(width % 2 == 0 && width >= kLeastVideoSide && width <= kLargestVideoSide);
    assert(height % 2 == 0 && height >= kLeastVideoSide && height <= kLargestVideoSide);
    if (const auto known = checkVideoFile(file); !known) return tl::unexpected(known.error());
    auto output = VideoOutput::open(file);
    if (!output) return tl::unexpected(output.error());
    return ends(file, kGifEnding) ? beginGif(std::move(*output), width, height)
                                  : beginWebm(std::move(*output), width, height);
}

} // namespace tactum
