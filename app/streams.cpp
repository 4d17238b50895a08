#include "app/streams.h"

#include <algorithm>
#include <fstream>
#include <iostream>

#include "app/results.h"
#include "app/terminal_progress.h"
#include "core/files/source.h"
#include "core/files/tell_format.h"
#include "core/import/import_scene.h"

namespace tactum {
namespace {

namespace fs = std::filesystem;

constexpr const char* kInput = "standard input";

constexpr std::uint64_t kMost = std::uint64_t(2) << 30;

tl::unexpected<Error> refused(const std::string& why) {
    return inputError(std::string(kInput) + ": " + why);
}

/// At most `count` bytes, fewer at the end.
std::string taken(std::size_t count) {
    std::string bytes(count, '\0');
    std::cin.read(bytes.data(), std::streamsize(count));
    bytes.resize(std::size_t(std::cin.gcount()));
    return bytes;
}

/// All of it goes to `file`, a block at a time, for it may go on for ever: what is of no format ends with its
/// head, and no other goes beyond the size that it announces. Gives the ending.
Result<std::string> keepInput(const fs::path& file) {
    constexpr const char* kUntold = "cannot tell its format; give the file by its name";
    std::string head = taken(kTellingHead);
    if (head.empty()) return refused("is empty; send it a scene");
    const auto announced = announcedSize(head);
    if (toldEnding(head, head.size()).empty() &&
        (!announced || *announced < head.size() || *announced > kMost))
        return refused(kUntold);
    std::ofstream out(file, std::ios::binary);
    std::uint64_t size = 0;
    for (std::string block = head; !block.empty() && out; block = taken(std::size_t(1) << 20)) {
        if ((size += block.size()) > kMost) return refused("is longer than 2 GiB; give the file by its name");
        if (announced && size > *announced) return refused("is longer than its head says; export it again");
        out << block;
    }
    out.close();
    if (!out)
        return machineError(std::string(kInput) +
                            ": cannot be kept in the folder for temporary files; make room there");
    const std::string_view ending = toldEnding(head, size);
    if (ending.empty()) return refused(kUntold);
    return std::string(ending);
}

} // namespace

Error renamed(Error error, const ScratchFolder& of, const std::string& name) {
    const std::string folder = of.path().string() + "/";
    for (std::size_t at = error.text.find(folder); at != std::string::npos;
         at = error.text.find(folder, at)) {
        const std::size_t end = error.text.find(':', at);
        error.text.replace(at, std::min(end, error.text.size()) - at, name);
    }
    return error;
}

namespace {

Result<LoadedScene> importWhole(const fs::path& file) {
    const TerminalProgress terminal("reading " + (isDash(file) ? std::string(kInput) : shownPath(file)));
    if (!isDash(file)) return importScene(file, terminal.progress());
    const ScratchFolder folder("pipe");
    if (folder.path().empty())
        return machineError(std::string(kInput) +
                            ": there is no folder for temporary files; set TMPDIR to one");
    const fs::path kept = folder.path() / "standard-input";
    const auto ending = keepInput(kept);
    if (!ending) return tl::unexpected<Error>(ending.error());
    const fs::path copy = folder.path() / ("standard-input." + *ending);
    std::error_code fault; // which the import says
    fs::rename(kept, copy, fault);
    auto loaded = importScene(copy, terminal.progress());
    if (!loaded) return tl::unexpected<Error>(renamed(loaded.error(), folder, kInput));
    return loaded;
}

} // namespace

Result<LoadedScene> importGiven(const fs::path& file, const GivenAxes& axes) {
    auto loaded = importWhole(file);
    if (!loaded) return loaded;
    if (const auto taken = takeAsGiven(*loaded, axes, file); !taken) return tl::unexpected(taken.error());
    return loaded;
}

} // namespace tactum
