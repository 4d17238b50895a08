// A video that is written picture by picture.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace tactum {

/// The endings of videos, without dot: VP8 in WebM, and GIF.
inline constexpr const char* kWebmEnding = "webm";
inline constexpr const char* kGifEnding = "gif";
/// Pictures a second, and how long one of them is shown, s.
inline constexpr int kVideoRate = 30;
inline constexpr double kVideoPeriod = 1.0 / kVideoRate;
/// Pixels of a side.
inline constexpr int kLeastVideoSide = 16, kLargestVideoSide = 8192;

/// Rows from above; a pixel is 0xffRRGGBB, sRGB.
struct VideoPicture {
    int width = 0, height = 0;
    std::vector<std::uint32_t> pixels;
};

/// A picture is shown from its time until the next one's. Whatever ends the program, what was added so far is
/// in the file and can be played. Errors of all members: the machine's, one line with the path; how much of
/// the video is in the file is in it. Thread: one at a time, any but real time.
class VideoFile {
public:
    virtual ~VideoFile() = default;

    /// Every picture has the size of the video. `time`: s since the beginning, 0 or more; one that is not
    /// later than the last one, as the file counts (1 ms of WebM, 20 ms of GIF), is left out.
    virtual Result<void> add(const VideoPicture& picture, double time) = 0;
    /// `end`: until when the last picture is shown, s. Nothing can be added after it.
    virtual Result<void> finish(double end) = 0;
};

/// Whether beginVideo() knows the ending.
Result<void> checkVideoFile(const std::filesystem::path& file);
/// Begins a video by the ending of its file, whose place it takes at once. Width and height: even,
/// from kLeastVideoSide to kLargestVideoSide. Errors: another ending, what is no ordinary file (input), one
/// that cannot be written (machine). Thread: any but real time.
Result<std::unique_ptr<VideoFile>> beginVideo(const std::filesystem::path& file, int width, int height);

} // namespace tactum
