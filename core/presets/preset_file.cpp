#include "core/presets/preset_file.h"

#include <algorithm>

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/files/gltf/gltf_surface.h"
#include "core/files/guarded.h"
#include "core/files/images/read_image.h"
#include "core/files/images/write_png.h"
#include "core/presets/base64.h"
#include "core/surface/texture_stack.h"

namespace tactum {
namespace {

constexpr const char* kVersionKey = "tactumPreset";
constexpr std::string_view kPictureHead = "data:image/png;base64,";
constexpr std::size_t kLongestText = 4000, kMaxTags = 64;

std::string versionText() {
    return std::to_string(kPresetMajor) + "." + std::to_string(kPresetMinor);
}

/// Number of texels from the header of a PNG file; 0 where it is none.
std::uint32_t pngSide(std::string_view png, std::size_t at) {
    if (png.size() < 24 || !png.starts_with("\x89PNG\r\n\x1a\n")) return 0;
    std::uint32_t side = 0;
    for (std::size_t i = 0; i < 4; ++i)
        side = side << 8 | std::uint8_t(png[at + i]);
    return side;
}

class PresetReader {
public:
    explicit PresetReader(const Source& source) : source_(source), root_(rootOf(source)) {}

    LoadedPreset read() {
        checkVersion();
        Preset& preset = made_.preset;
        preset.name = text(root_, "name", "");
        if (trimmed(preset.name).empty()) source_.fail("has no name; give it one in \"name\"");
        preset.category = text(root_, "category", "");
        readTags();
        readColour();
        readFeel();
        readSources();
        preset.kept = std::make_shared<const std::string>(root_.dump());
        return std::move(made_);
    }

private:
    static Json rootOf(const Source& source) {
        GltfFile file = openGltf(source);
        if (file.isBinary) source.fail("is a glb file; open it as a scene");
        return std::move(file.json);
    }

    [[noreturn]] void failAt(const std::string& where, const std::string& what) const {
        source_.fail(where + " " + what);
    }

    void checkVersion() const {
        const Json* version = member(root_, kVersionKey);
        if (!version)
            source_.fail(std::string("is no preset: it has no \"") + kVersionKey +
                         "\"; choose a file that ends in ." + std::string(kPresetEnding));
        const std::string said = version->is_string() ? version->get<std::string>() : version->dump();
        const std::size_t point = said.find('.');
        std::int64_t major = 0, minor = 0;
        if (!version->is_string() || point == said.npos || !parseNumber(said.substr(0, point), major) ||
            !parseNumber(said.substr(point + 1), minor) || major < 1 || minor < 0)
            failAt(kVersionKey, "is " + inQuotes(said) + "; write it as \"" + versionText() + "\"");
        if (major > kPresetMajor)
            source_.fail("is a preset of format " + printable(said, 20) +
                         ", which is later than this program; get a newer Tactum");
    }

    std::string text(const Json& object, const char* key, const std::string& inside) const {
        const Json* found = member(object, key);
        if (!found) return {};
        if (!found->is_string()) failAt(inside + key, "is not a text; put it in quotes");
        return printable(found->get<std::string>(), kLongestText);
    }

    void readTags() {
        const Json* tags = member(root_, "tags");
        if (!tags) return;
        const bool words = tags->is_array() && tags->size() <= kMaxTags &&
                           std::ranges::all_of(*tags, [](const Json& tag) { return tag.is_string(); });
        if (!words) failAt("tags", "is not a list of up to 64 texts; repair or remove it");
        for (const Json& tag : *tags)
            made_.preset.tags.push_back(printable(tag.get<std::string>(), 100));
    }

    void readColour() {
        const Json* colour = member(root_, "colour");
        if (!colour) return;
        const auto isPart = [](const Json& part) {
            return part.is_number() && part.get<double>() >= 0 && part.get<double>() <= 1;
        };
        if (!colour->is_array() || colour->size() != 3 || !std::ranges::all_of(*colour, isPart))
            failAt("colour", "is not a list of three numbers from 0 to 1; repair or remove it");
        Vec3& read = made_.preset.colour.emplace();
        for (std::size_t i = 0; i < 3; ++i)
            read[Eigen::Index(i)] = (*colour)[i].get<double>();
    }

    void readFeel() {
        const Json* feel = member(root_, "feel");
        if (!feel || !feel->is_object()) failAt("feel", "is missing or no object; it holds the values");
        Surface surface;
        std::vector<std::string> complaints;
        const ReadShared shared{[this](int index) { return picture(index); },
                                [](const Json&) { return std::shared_ptr<const PaintedValues>(); }};
        readSurfaceJson(*feel, "feel", shared, surface, complaints);
        if (!complaints.empty()) source_.fail(complaints.front() + "; repair or remove it");
        takeValues(*feel, surface.material);
        if (member(*feel, kShadingPart)) {
            check("feel.shading", kCreaseAngle, surface.shading.creaseAngle);
            made_.preset.shading = surface.shading;
        }
        if (member(*feel, kLayersPart)) takeLayers(std::move(surface.layers));
    }

    void takeValues(const Json& feel, const Material& material) {
        for (std::size_t i = 0; i < kMaterialFields.size(); ++i) {
            const Parameter& parameter = *kMaterialFields[i].parameter;
            if (!member(feel, jsonKey(parameter.key).c_str())) continue;
            const double value = material.*kMaterialFields[i].value;
            check("feel", parameter, value);
            made_.preset.values[i] = value;
        }
        const Material felt = applied({}, made_.preset).material;
        for (std::size_t i = 0; i < kMaterialFields.size(); ++i)
            if (made_.preset.values[i] && felt.*kMaterialFields[i].value != *made_.preset.values[i])
                failAt("feel.dynamicFriction", "is above feel.staticFriction; lower it");
    }

    void check(const std::string& where, const Parameter& parameter, double value) const {
        if (parameter.allows(value)) return;
        std::string range;
        appendNumber(range, parameter.minimum);
        appendNumber(range += " to ", parameter.maximum);
        if (!parameter.unit.empty()) range += " " + std::string(parameter.unit);
        std::string is;
        appendNumber(is, value);
        failAt(where + "." + jsonKey(parameter.key), "is " + is + "; set it inside " + range);
    }

    void takeLayers(std::vector<TextureLayer> layers) {
        if (layers.size() > std::size_t(kMaxTextureLayers))
            failAt("feel.layers", "has " + std::to_string(layers.size()) + " layers; leave at most " +
                                      std::to_string(kMaxTextureLayers));
        for (std::size_t i = 0; i < layers.size(); ++i) {
            const std::string where = "feel.layers[" + std::to_string(i) + "]";
            const TextureLayer& layer = layers[i];
            const Parameter& strength = strengthParameter(layer.target);
            if (!strength.allows(layer.strength))
                failAt(where + ".strength",
                       "is outside the range of a " + std::string(strength.label) + "; see docs/format.md");
            check(where, kTextureOpacity, layer.opacity);
            checkPattern(where + ".pattern", layer.pattern);
            if (layer.mask) checkPattern(where + ".mask", *layer.mask);
        }
        made_.preset.layers = std::move(layers);
    }

    void checkPattern(const std::string& where, const TexturePattern& pattern) const {
        for (const PatternField& field : kPatternFields)
            check(where, *field.parameter, pattern.*field.value);
        if (!pattern.frame.translation.allFinite())
            failAt(where + ".frame", "is no place; repair or remove it");
        if (pattern.source == TextureSource::Painted)
            failAt(where, "is painted, and that belongs to one mesh; choose another source");
        if (pattern.source == TextureSource::Image && !pattern.image)
            failAt(where, "names no picture; give it a \"texture\" with an \"index\"");
    }

    std::shared_ptr<const TextureImage> picture(int index) {
        const Json* all = member(root_, "images");
        const std::string where = "images[" + std::to_string(index) + "]";
        if (!all || !all->is_array() || index < 0 || std::size_t(index) >= all->size())
            failAt("images", "has not every picture that feel.layers names; export the preset again");
        if (const auto known = pictures_.find(index); known != pictures_.end()) return known->second;
        const Json& entry = (*all)[std::size_t(index)];
        const std::string uri = addressOf(entry);
        if (!uri.starts_with(kPictureHead))
            failAt(where, "has no \"uri\" that begins with " + std::string(kPictureHead) +
                              "; export the preset again");
        const auto png = fromBase64(std::string_view(uri).substr(kPictureHead.size()));
        const std::uint32_t width = png ? pngSide(*png, 16) : 0, height = png ? pngSide(*png, 20) : 0;
        if (width == 0 || height == 0) failAt(where, "is no PNG picture; export the preset again");
        if (width > kLargestPresetPicture || height > kLargestPresetPicture)
            failAt(where, "has more than " + std::to_string(kLargestPresetPicture) +
                              " texels a side; make the picture smaller");
        const Json* name = member(entry, "name");
        const std::string called = name && name->is_string() ? name->get<std::string>() : "picture";
        const auto loaded = readImage(*png, printable(called), source_.path());
        if (!loaded) throw ReadFault{loaded.error()};
        return pictures_[index] = loaded->image;
    }

    static std::string addressOf(const Json& entry) {
        const Json* uri = member(entry, "uri");
        return uri && uri->is_string() ? uri->get<std::string>() : std::string();
    }

    void readSources() {
        const Json* sources = member(root_, "sources");
        if (!sources) return;
        if (!sources->is_object()) failAt("sources", "is no object; it has one for each value of \"feel\"");
        for (const auto& [key, said] : sources->items()) {
            const std::string inside = "sources." + printable(key) + ".";
            if (!said.is_object()) failAt("sources." + printable(key), "is no object; give it \"words\"");
            PresetSource source{text(said, "words", inside), text(said, "link", inside), false};
            if (const Json* typical = member(said, "typical")) {
                if (!typical->is_boolean()) failAt(inside + "typical", "is not true or false; repair it");
                source.typical = typical->get<bool>();
            }
            if (isPart(key)) made_.preset.sources[key] = std::move(source);
        }
    }

    static bool isPart(std::string_view key) {
        return key == kShadingPart || key == kLayersPart ||
               std::ranges::any_of(kMaterialFields, [&](const MaterialField& field) {
                   return jsonKey(field.parameter->key) == key;
               });
    }

    const Source& source_;
    Json root_;
    LoadedPreset made_;
    std::map<int, std::shared_ptr<const TextureImage>> pictures_;
};

/// The pictures of layers, each once, in the order in which they are asked for.
class Pictures {
public:
    int indexOf(const std::shared_ptr<const TextureImage>& image) {
        const auto found = std::ranges::find(images_, image);
        if (found != images_.end()) return int(found - images_.begin());
        images_.push_back(image);
        return int(images_.size()) - 1;
    }
    Json json() const {
        Json all = Json::array();
        for (const auto& image : images_)
            all.push_back(
                {{"name", image->name()}, {"uri", std::string(kPictureHead) + base64Of(encodePng(*image))}});
        return all;
    }

private:
    std::vector<std::shared_ptr<const TextureImage>> images_;
};

Json feelJson(const Preset& preset, Pictures& pictures) {
    const WriteShared shared{[&](const auto& image) { return pictures.indexOf(image); },
                             [](const auto&) { return Json(); }};
    Json whole = surfaceJson(applied({}, preset), shared);
    Json feel = Json::object();
    const auto take = [&](const std::string& key) { feel[key] = std::move(whole[key]); };
    for (std::size_t i = 0; i < kMaterialFields.size(); ++i)
        if (preset.values[i]) take(jsonKey(kMaterialFields[i].parameter->key));
    if (preset.shading) take(kShadingPart);
    if (preset.layers) take(kLayersPart);
    return feel;
}

Json sourcesJson(const Preset& preset) {
    Json all = Json::object();
    for (const auto& [key, source] : preset.sources) {
        Json& said = all[key] = {{"words", source.words}};
        if (!source.link.empty()) said["link"] = source.link;
        if (source.typical) said["typical"] = true;
    }
    return all;
}

/// Lays what we know over what was there: members that only the file has stay.
void overlay(Json& below, const Json& above) {
    if (below.is_object() && above.is_object()) {
        for (const auto& [key, value] : above.items())
            overlay(below[key], value);
    } else if (below.is_array() && above.is_array() && below.size() == above.size()) {
        for (std::size_t i = 0; i < above.size(); ++i)
            overlay(below[i], above[i]);
    } else {
        below = above;
    }
}

constexpr const char* kNoMemory = "for the preset; close other programs";

} // namespace

Result<LoadedPreset> readPreset(const std::filesystem::path& file) {
    return guarded<LoadedPreset>(file, kNoMemory,
                                 [&] { return PresetReader(Source::open(file, kLargestPreset)).read(); });
}

Result<LoadedPreset> parsePreset(std::string_view text, const std::filesystem::path& where) {
    if (text.size() > kLargestPreset) return inputError(shownPath(where) + ": is too large for a preset");
    return guarded<LoadedPreset>(where, kNoMemory,
                                 [&] { return PresetReader(Source::ofBytes(where, text)).read(); });
}

std::string presetText(const Preset& preset) {
    Pictures pictures;
    Json own{{kVersionKey, versionText()}, {"name", preset.name}};
    if (preset.colour) own["colour"] = vectorJson(*preset.colour);
    if (!preset.category.empty()) own["category"] = preset.category;
    if (!preset.tags.empty()) own["tags"] = preset.tags;
    own["feel"] = feelJson(preset, pictures);
    own["sources"] = sourcesJson(preset);
    if (Json images = pictures.json(); !images.empty()) own["images"] = std::move(images);
    Json all = preset.kept ? Json::parse(*preset.kept, nullptr, false) : Json::object();
    if (!all.is_object()) all = Json::object();
    overlay(all, own);
    return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string presetFileName(std::string_view name) {
    constexpr std::size_t kLongest = 60;
    std::string file;
    for (const char c : lowerCase(name)) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        if (plain)
            file += c;
        else if (!file.empty() && file.back() != '-')
            file += '-';
    }
    file.resize(std::min(file.size(), kLongest));
    while (file.ends_with('-'))
        file.pop_back();
    return file.empty() ? "preset" : file;
}

} // namespace tactum
