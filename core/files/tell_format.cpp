#include "core/files/tell_format.h"

#include <algorithm>

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

/// OBJ has no beginning of its own, but every line of it begins with one of these or a comment.
constexpr std::string_view kObjWords[] = {
    "v",      "vt",  "vn",       "vp",       "f",          "fo",       "l",      "p",
    "o",      "g",   "s",        "mg",       "usemtl",     "mtllib",   "usemap", "maplib",
    "cstype", "deg", "bmat",     "step",     "curv",       "curv2",    "surf",   "parm",
    "bevel",  "lod", "c_interp", "d_interp", "shadow_obj", "trace_obj"};

bool isObj(std::string_view head) {
    const std::string_view word = Fields(head.substr(0, head.find('\n'))).next();
    return word.starts_with('#') || std::ranges::find(kObjWords, word) != std::end(kObjWords);
}

std::uint64_t numberAt(std::string_view bytes, std::size_t at) {
    std::uint64_t number = 0;
    for (std::size_t i = 4; i-- > 0;)
        number = number << 8 | std::uint8_t(bytes[at + i]);
    return number;
}

std::optional<std::uint64_t> sizeOfBinaryStl(std::string_view head) {
    constexpr std::size_t kHead = 84, kFacet = 50;
    return head.size() < kHead ? std::nullopt : std::optional(kHead + kFacet * numberAt(head, 80));
}

/// By its first bytes, which those of a binary STL do not say.
std::string_view endingByBeginning(std::string_view head) {
    if (head.starts_with("\xEF\xBB\xBF")) head.remove_prefix(3);
    while (!head.empty() && (isBlank(head.front()) || head.front() == '\n'))
        head.remove_prefix(1);
    const auto has = [&](std::string_view word) { return head.find(word) != std::string_view::npos; };
    if (head.starts_with("PK") && (has("[Content_Types].xml") || has("3D/3dmodel.model"))) return "3mf";
    for (const Beginning& beginning : kBeginnings)
        if (head.starts_with(beginning.bytes)) return beginning.ending;
    if (has("<X3D")) return "x3d";
    if (has("<COLLADA")) return "dae";
    return isObj(head) && head.find('\0') == std::string_view::npos ? "obj" : std::string_view();
}

} // namespace

std::string_view toldEnding(std::string_view head, std::uint64_t size) {
    head = head.substr(0, kTellingHead);
    return sizeOfBinaryStl(head) == size ? "stl" : endingByBeginning(head);
}

std::optional<std::uint64_t> announcedSize(std::string_view head) {
    head = head.substr(0, kTellingHead);
    const std::string_view ending = endingByBeginning(head);
    if (ending == "glb" && head.size() >= 12) return numberAt(head, 8);
    return ending.empty() ? sizeOfBinaryStl(head) : std::nullopt;
}

} // namespace tactum
