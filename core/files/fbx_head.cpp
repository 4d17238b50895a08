#include "core/files/fbx_head.h"

#include <charconv>
#include <cstdint>

namespace tactum {
namespace {

constexpr std::string_view kBinary{"Kaydara FBX Binary  \0\x1A", 22};
constexpr unsigned kOldest = 7000; // Assimp knows no older ones

/// The number after `key`, wherever it stands in the beginning of a text.
unsigned numberAfter(std::string_view text, std::string_view key) {
    std::size_t at = text.find(key);
    if (at == std::string_view::npos) return 0;
    at = text.find_first_of("0123456789", at + key.size());
    unsigned number = 0;
    if (at != std::string_view::npos) std::from_chars(text.data() + at, text.data() + text.size(), number);
    return number;
}

unsigned versionOfBinary(std::string_view bytes) {
    unsigned version = 0;
    for (std::size_t i = 4; i-- > 0;)
        version = version << 8 | std::uint8_t(bytes[23 + i]);
    return version;
}

unsigned versionOf(std::string_view bytes) {
    if (bytes.starts_with(kBinary)) return bytes.size() < 27 ? 0 : versionOfBinary(bytes);
    const std::string_view beginning = bytes.substr(0, 4096);
    if (const unsigned version = numberAfter(beginning, "FBXVersion:")) return version;
    // "; FBX 6.1.0 project file"
    return beginning.starts_with("; FBX ") ? 1000 * numberAfter(beginning.substr(0, 12), "; FBX ") : 0;
}

} // namespace

std::optional<std::string> fbxRefusal(std::string_view bytes) {
    constexpr const char* kRemedy = "; export it as FBX 7.4 or as glTF from the program that made it";
    if (bytes.starts_with(kBinary) && bytes.size() > 22 && bytes[22] != 0)
        return "is an FBX file whose bytes are in the big-endian order, which is not read" +
               std::string(kRemedy);
    const unsigned version = versionOf(bytes);
    if (version == 0 || version >= kOldest) return std::nullopt;
    return "is an FBX file of version " + std::to_string(version / 1000) + "." +
           std::to_string(version / 100 % 10) + "; only those from 7.0 (2011) on are read" + kRemedy;
}

std::optional<Mat3> fromFbxAxes(const FbxAxis& side, const FbxAxis& up, const FbxAxis& front) {
    Mat3 axes = Mat3::Zero();
    int row = 0;
    for (const FbxAxis& from : {side, up, front}) {
        if (from.axis < 0 || from.axis > 2 || (from.sign != 1 && from.sign != -1)) return std::nullopt;
        axes(row++, from.axis) = from.sign;
    }
    if (std::abs(axes.determinant()) != 1) return std::nullopt; // two of them are the same
    return axes;
}

} // namespace tactum
