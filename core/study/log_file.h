// A file that only grows: what was written to it outlives the program, and after keep() the machine.
#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/result.h"

namespace tactum {

/// Errors: one line with the path and the remedy. Thread: any but real time, one at a time.
class LogFile {
public:
    /// A new file; never one that is there already.
    static Result<LogFile> create(const std::filesystem::path& file);
    /// Goes on behind the first `bytes` of a file; what comes after them is cut off.
    static Result<LogFile> goOn(const std::filesystem::path& file, std::size_t bytes);
    LogFile(LogFile&& other) noexcept;
    LogFile& operator=(LogFile&& other) noexcept;
    ~LogFile();

    /// The system has them: a crash of the program takes none of them away.
    Result<void> write(std::string_view bytes);
    /// The disk has them.
    Result<void> keep();
    const std::filesystem::path& path() const { return path_; }

private:
    LogFile(std::filesystem::path path, int number) : path_(std::move(path)), number_(number) {}
    static Result<LogFile> opened(const std::filesystem::path& file, int flags);

    std::filesystem::path path_;
    int number_ = -1;
};

} // namespace tactum
