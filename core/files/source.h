// The bytes of one file and how to speak of places in it. For readers only.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace tactum {

/// Thrown by a reader at the first fault; loadScene() and readFingerPath() catch it. Never leaves a reader.
struct ReadFault {
    Error error;
};

/// A file in memory, whole.
class Source {
public:
    /// Reads a regular file of at most `limit` bytes. Throws ReadFault.
    static Source open(const std::filesystem::path& file, std::uint64_t limit, const Progress& progress = {});
    /// The same, or a pipe up to its end. It waits for whoever writes, so only where a person can stop it.
    static Source openFileOrPipe(const std::filesystem::path& file, std::uint64_t limit);

    /// Bytes that are in memory already; `name` stands for them in sentences.
    static Source ofBytes(const std::filesystem::path& name, std::string_view bytes);

    std::string_view bytes() const { return {data_.get(), size_}; }
    const std::string& name() const { return name_; } ///< the path as given, printable
    const std::filesystem::path& path() const { return path_; }

    [[noreturn]] void fail(const std::string& text) const;
    [[noreturn]] void failAtLine(std::size_t line, const std::string& text) const;
    [[noreturn]] void failAtByte(std::size_t byte, const std::string& text) const;
    /// The line, from 1, of a place inside bytes().
    std::size_t lineAt(const char* place) const;

private:
    explicit Source(const std::filesystem::path& file);

    std::filesystem::path path_;
    std::string name_;
    std::unique_ptr<char[]> data_;
    std::size_t size_ = 0;
};

/// How a file is named to a person: the path as given, printable.
std::string shownPath(const std::filesystem::path& file);

/// Throws when the work is to stop.
void demandGoingOn(ProgressMeter& meter, std::size_t done);

/// The file that `reference` names inside `folder`, and nowhere else: not absolute, not through "..", not
/// through a symbolic link that leads out. Empty when there is no such file.
std::filesystem::path insideFolder(const std::filesystem::path& folder, const std::string& reference);

} // namespace tactum
