#include "core/files/gltf/gltf_file.h"

#include <algorithm>
#include <optional>

#include "core/base/text.h"

namespace tactum {
namespace {

constexpr std::size_t kDeepestJson = 128, kMostNodes = 100'000;
constexpr std::size_t kMostJson = 1'500'000; ///< lists and objects: three seconds and half a gigabyte of them

std::uint32_t word(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;)
        value = value << 8 | std::uint8_t(bytes[at + i]);
    return value;
}

/// Parsers and printers of JSON call themselves for every level, and each list and object is memory of its
/// own.
void demandBounded(const Source& source, std::string_view json) {
    std::size_t depth = 0, count = 0;
    bool inString = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (inString && c == '\\')
            ++i;
        else if (c == '"')
            inString = !inString;
        else if (!inString && (c == '{' || c == '[')) {
            if (++depth > kDeepestJson) source.fail("nests deeper than 128 levels; re-export the file");
            if (++count > kMostJson)
                source.fail(
                    "has more than 1,500,000 lists and objects in its JSON; keep numbers in buffers, and "
                    "leave out what shows nothing");
        } else if (!inString && (c == '}' || c == ']') && depth > 0)
            --depth;
    }
}

/// Each one costs what a hundred triangles do, and is looked at by everything that follows.
void demandFewNodes(const Source& source, const Json& json) {
    const auto nodes = json.find("nodes");
    if (nodes == json.end() || !nodes->is_array() || nodes->size() <= kMostNodes) return;
    source.fail("has " + std::to_string(nodes->size()) + " nodes, and at most " + std::to_string(kMostNodes) +
                " are read; join meshes, and leave out nodes that show nothing");
}

/// What the asset says under a key, as text; nothing where it says nothing.
std::optional<std::string> saidOfAsset(const Json& json, const char* key) {
    const auto asset = json.find("asset");
    const bool says = asset != json.end() && asset->is_object() && asset->contains(key);
    if (!says) return std::nullopt;
    const Json& said = (*asset)[key];
    return said.is_string() ? said.get<std::string>() : said.dump();
}

/// A later version may say that readers of 2.0 do. Version 1 has objects where version 2 has arrays, and
/// would be a file with nothing in it.
void demandVersion2(const Source& source, const Json& json) {
    const auto meshes = json.find("meshes");
    const auto version = saidOfAsset(json, "version"), least = saidOfAsset(json, "minVersion");
    const bool isUnsaidOld = !version && meshes != json.end() && meshes->is_object();
    if (isUnsaidOld || (version && (*version == "1" || version->starts_with("1."))))
        source.fail("is glTF 1.0, and only 2.0 is read; open it in a program of its time, or convert it by "
                    "gltf-pipeline");
    const bool fits = least ? *least == "2.0" : !version || *version == "2" || version->starts_with("2.");
    if (!fits)
        source.fail("asks for a reader of glTF " + inQuotes(least.value_or(version.value_or(""))) +
                    ", and only 2.0 is read; export it as glTF 2.0");
}

Json parseJson(const Source& source, std::string_view text) {
    demandBounded(source, text);
    try {
        if (Json json = Json::parse(text); json.is_object()) {
            demandVersion2(source, json);
            demandFewNodes(source, json);
            return json;
        }
    } catch (const Json::parse_error& mistake) {
        if (text.data() == source.bytes().data()) // in a part of a binary file lines say nothing
            source.failAtLine(source.lineAt(text.data() + std::min(mistake.byte, text.size())),
                              "its JSON cannot be parsed; repair that line or re-export the file");
    } catch (const Json::exception&) { // a number that no double can hold
    }
    source.fail("its JSON cannot be parsed; re-export the file");
}

} // namespace

GltfFile openGltf(const Source& source) {
    constexpr std::uint32_t kMagic = 0x46546C67, kJson = 0x4E4F534A, kBinary = 0x004E4942;
    const std::string_view bytes = source.bytes();
    if (bytes.size() < 4 || word(bytes, 0) != kMagic) {
        GltfFile text;
        text.json = parseJson(source, bytes);
        return text;
    }
    if (bytes.size() < 20 || word(bytes, 8) != bytes.size())
        source.fail("the length in its header is not that of the file; it was cut short, copy it again");
    if (word(bytes, 4) != 2)
        source.fail("is glb version " + std::to_string(word(bytes, 4)) +
                    "; only version 2 is read, export it again");
    GltfFile parts;
    parts.isBinary = true;
    for (std::size_t at = 12; at < bytes.size();) {
        if (bytes.size() - at < 8 || word(bytes, at) > bytes.size() - at - 8)
            source.failAtByte(at, "a chunk reaches beyond the end; the file was cut short, copy it again");
        const std::string_view chunk = bytes.substr(at + 8, word(bytes, at));
        if ((at == 12) != (word(bytes, at + 4) == kJson))
            source.failAtByte(at, "the first chunk, and only that, must be JSON; re-export the file");
        if (at == 12)
            parts.json = parseJson(source, chunk);
        else if (word(bytes, at + 4) == kBinary && parts.binary.empty())
            parts.binary = chunk;
        at += 8 + chunk.size();
    }
    return parts;
}

std::string packGlb(const Json& json, std::string_view binary) {
    std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const auto put = [](std::string& to, std::size_t value) {
        for (int shift = 0; shift < 32; shift += 8)
            to += char(value >> shift & 0xFF);
    };
    const std::size_t padded = (binary.size() + 3) / 4 * 4;
    std::string glb = "glTF";
    glb.reserve(28 + text.size() + padded);
    put(glb, 2);
    put(glb, 20 + text.size() + (padded ? 8 + padded : 0));
    put(glb, text.size());
    glb += "JSON" + text;
    if (padded == 0) return glb;
    put(glb, padded);
    glb.append("BIN\0", 4).append(binary).resize(glb.size() + padded - binary.size());
    return glb;
}

} // namespace tactum
