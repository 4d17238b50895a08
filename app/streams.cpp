#include "app/streams.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>

#include "app/results.h"
#include "core/base/text.h"
#include "core/import/import_scene.h"

namespace tactum {
namespace {

namespace fs = std::filesystem;

constexpr const char* kInput = "standard input";

/// How files of a format begin, and its ending.
struct Beginning {
    std::string_view bytes, ending;
};
constexpr Beginning kBeginnings[] = {{"glTF", "glb"},
                                     {"PK\x03\x04", "tactum"},
                                     {"ply", "ply"},
                                     {"solid", "stl"},
                                     {"Kaydara FBX Binary", "fbx"},
                                     {"; FBX", "fbx"},
                                     {"MM", "3ds"},
                                     {"{", "gltf"},
                                     {"OFF", "off"},
                                     {"COFF", "off"},
                                     {"NOFF", "off"},
                                     {"STOFF", "off"},
                                     {"CNOFF", "off"},
                                     {"STNOFF", "off"},
                                     {"STCNOFF", "off"}};

bool isBinaryStl(std::string_view bytes) {
    constexpr std::size_t kHead = 84, kFacet = 50;
    if (bytes.size() < kHead) return false;
    std::size_t count = 0;
    for (std::size_t i = 4; i-- > 0;)
        count = count << 8 | std::uint8_t(bytes[80 + i]);
    return bytes.size() == kHead + kFacet * count;
}

/// The ending that the file would have; empty for what cannot be told.
std::string_view toldEnding(std::string_view bytes) {
    std::string_view head = bytes.substr(0, 4096);
    if (isBinaryStl(bytes)) return "stl";
    if (head.starts_with("\xEF\xBB\xBF")) head.remove_prefix(3);
    while (!head.empty() && (isBlank(head.front()) || head.front() == '\n'))
        head.remove_prefix(1);
    if (head.starts_with("PK") && head.find("[Content_Types].xml") != std::string_view::npos) return "3mf";
    for (const Beginning& beginning : kBeginnings)
        if (head.starts_with(beginning.bytes)) return beginning.ending;
    if (head.find("<X3D") != std::string_view::npos) return "x3d";
    if (head.find("<COLLADA") != std::string_view::npos) return "dae";
    if (head.starts_with("<") || head.find('\0') != std::string_view::npos) return {};
    return "obj"; // which has no beginning
}

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

PipeFolder::PipeFolder() {
    std::error_code fault;
    std::string name = (fs::temp_directory_path(fault) / "tactum-XXXXXX").string();
    if (!fault && mkdtemp(name.data())) path_ = name;
}

PipeFolder::~PipeFolder() {
    std::error_code fault;
    if (!path_.empty()) fs::remove_all(path_, fault);
}

Error PipeFolder::renamed(Error error, const std::string& name) const {
    const std::string folder = path_.string() + "/";
    for (std::size_t at = error.text.find(folder); at != std::string::npos;
         at = error.text.find(folder, at)) {
        const std::size_t end = error.text.find(':', at);
        error.text.replace(at, std::min(end, error.text.size()) - at, name);
    }
    return error;
}

Result<LoadedScene> importGiven(const fs::path& file) {
    if (!isStandardOutput(file)) return importScene(file);
    const auto bytes = wholeInput();
    if (!bytes) return tl::unexpected<Error>(bytes.error());
    const std::string_view ending = toldEnding(*bytes);
    if (ending.empty())
        return inputError(std::string(kInput) + ": cannot tell its format; give the file by its name");
    const PipeFolder folder;
    const fs::path copy = folder.path() / ("standard-input." + std::string(ending));
    std::ofstream out(copy, std::ios::binary);
    out << *bytes;
    out.close();
    if (folder.path().empty() || !out)
        return machineError(std::string(kInput) +
                            ": cannot be kept in the folder for temporary files; make room there");
    auto loaded = importScene(copy);
    if (!loaded) return tl::unexpected<Error>(folder.renamed(loaded.error(), kInput));
    return loaded;
}

} // namespace tactum
