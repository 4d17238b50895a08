#include "app/streams.h"

#include <algorithm>
#include <fstream>
#include <iostream>

#include "app/results.h"
#include "core/files/tell_format.h"
#include "core/import/import_scene.h"

namespace tactum {
namespace {

namespace fs = std::filesystem;

constexpr const char* kInput = "standard input";

Result<std::string> wholeInput() {
    constexpr std::size_t kMost = std::size_t(2) << 30, kBlock = std::size_t(1) << 20;
    std::string bytes;
    for (std::string block(kBlock, '\0'); std::cin;) {
        std::cin.read(block.data(), std::streamsize(kBlock));
        bytes.append(block, 0, std::size_t(std::cin.gcount()));
        if (bytes.size() > kMost)
            return inputError(std::string(kInput) + ": is longer than 2 GiB; give the file by its name");
    }
    if (bytes.empty()) return inputError(std::string(kInput) + ": is empty; send it a scene");
    return bytes;
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

Result<LoadedScene> importGiven(const fs::path& file) {
    if (!isDash(file)) return importScene(file);
    const auto bytes = wholeInput();
    if (!bytes) return tl::unexpected<Error>(bytes.error());
    const std::string_view ending = toldEnding(*bytes);
    if (ending.empty())
        return inputError(std::string(kInput) + ": cannot tell its format; give the file by its name");
    const ScratchFolder folder("pipe");
    const fs::path copy = folder.path() / ("standard-input." + std::string(ending));
    std::ofstream out(copy, std::ios::binary);
    out << *bytes;
    out.close();
    if (folder.path().empty() || !out)
        return machineError(std::string(kInput) +
                            ": cannot be kept in the folder for temporary files; make room there");
    auto loaded = importScene(copy);
    if (!loaded) return tl::unexpected<Error>(renamed(loaded.error(), folder, kInput));
    return loaded;
}

} // namespace tactum
