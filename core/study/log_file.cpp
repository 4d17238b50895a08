#include "core/study/log_file.h"

#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "core/files/source.h"

namespace tactum {

namespace {

tl::unexpected<Error> fault(const std::filesystem::path& file, const char* remedy) {
    return machineError(shownPath(file) + ": " + std::generic_category().message(errno) + "; " + remedy);
}

} // namespace

Result<LogFile> LogFile::opened(const std::filesystem::path& file, int flags) {
    const int number = ::open(file.c_str(), O_WRONLY | O_CLOEXEC | flags, 0644);
    if (number < 0) return fault(file, "choose a folder where files can be written");
    return LogFile(file, number);
}

Result<LogFile> LogFile::create(const std::filesystem::path& file) {
    return opened(file, O_CREAT | O_EXCL);
}

Result<LogFile> LogFile::goOn(const std::filesystem::path& file, std::size_t bytes) {
    auto log = opened(file, O_APPEND);
    if (log && ::ftruncate(log->number_, off_t(bytes)) != 0) return fault(file, "begin a new run");
    return log;
}

LogFile::LogFile(LogFile&& other) noexcept
    : path_(std::move(other.path_)), number_(std::exchange(other.number_, -1)) {}

LogFile& LogFile::operator=(LogFile&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(number_, other.number_);
    return *this;
}

LogFile::~LogFile() {
    if (number_ >= 0) ::close(number_);
}

Result<void> LogFile::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(number_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return fault(path_, "make room on the disk");
        bytes.remove_prefix(std::size_t(written));
    }
    return {};
}

Result<void> LogFile::keep() {
    if (::fdatasync(number_) != 0 && errno != EINVAL) return fault(path_, "make room on the disk");
    return {};
}

} // namespace tactum
