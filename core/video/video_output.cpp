#include "core/video/video_output.h"

#include <cerrno>
#include <cmath>
#include <cstring>

#include "core/base/text.h"

namespace tactum {

namespace {

/// "3.2 s"
std::string tenths(double seconds) {
    char text[32];
    const long count = std::lround(10 * seconds);
    std::snprintf(text, sizeof text, "%ld.%ld s", count / 10, count % 10);
    return text;
}

} // namespace

Result<VideoOutput> VideoOutput::open(const std::filesystem::path& file) {
    VideoOutput output;
    output.name_ = printable(file.string(), 200);
    std::error_code unknown; // then opening it says more
    const auto status = std::filesystem::status(file, unknown);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        return inputError(output.name_ +
                          ": is no ordinary file, which a video has to be; choose another name");
    output.file_.reset(std::fopen(file.c_str(), "wbe"));
    if (!output.file_)
        return machineError(output.name_ + ": cannot be written (" + std::strerror(errno) +
                            "); choose another folder");
    return output;
}

bool VideoOutput::noted(bool good) {
    if (!good && reason_ == 0) reason_ = errno;
    return good;
}

bool VideoOutput::append(std::string_view bytes) {
    size_ += bytes.size();
    return noted(std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) == bytes.size());
}

bool VideoOutput::replace(std::uint64_t at, std::string_view bytes) {
    return noted(std::fseek(file_.get(), long(at), SEEK_SET) == 0 &&
                 std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) == bytes.size() &&
                 std::fseek(file_.get(), 0, SEEK_END) == 0);
}

bool VideoOutput::flush() {
    return noted(std::fflush(file_.get()) == 0);
}

bool VideoOutput::close() {
    return flush() && noted(std::fclose(file_.release()) == 0);
}

tl::unexpected<Error> VideoOutput::failure(double seconds) const {
    return machineError(name_ + ": the video ends at " + tenths(seconds) + ", for no more can be written (" +
                        std::strerror(reason_) + "); make room on the disk, or choose another folder");
}

} // namespace tactum
