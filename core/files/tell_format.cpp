#include "core/files/tell_format.h"

#include <cstddef>
#include <cstdint>

#include "core/base/text.h"

namespace tactum {
namespace {

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

} // namespace

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

} // namespace tactum
