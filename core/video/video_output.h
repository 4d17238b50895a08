// The file under a video: grows, and lets what was written before be replaced. For this folder only.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace tactum {

/// Errors: the machine's, one line with the path, the reason, and how much of the video is there.
class VideoOutput {
public:
    static Result<VideoOutput> open(const std::filesystem::path& file);

    /// Whether the operating system has taken everything so far; the reason is kept for failure().
    bool append(std::string_view bytes);
    /// Others instead of as many bytes at an earlier place.
    bool replace(std::uint64_t at, std::string_view bytes);
    /// Hands over what is in memory still: a crash of the program leaves it in the file.
    bool flush();
    bool close();
    std::uint64_t size() const { return size_; } ///< bytes

    /// `seconds`: of the video, that can be played.
    tl::unexpected<Error> failure(double seconds) const;

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    bool noted(bool good);

    std::string name_;
    std::unique_ptr<std::FILE, Close> file_;
    std::uint64_t size_ = 0;
    int reason_ = 0; ///< the first errno
};

} // namespace tactum
