#include "core/files/bump_layers.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/files/images/read_image.h"
#include "core/files/source.h"
#include "core/scene/value_checks.h"

namespace tactum {
namespace {

using Severity = Finding::Severity;

constexpr std::size_t kMaxTexelsOfAModel = TextureImage::kMaxTexels; // and the last one on top

/// As it is written, or by its bare name: many programs write where it lay on somebody's disk.
std::filesystem::path fileOf(const std::filesystem::path& folder, std::string reference) {
    std::replace(reference.begin(), reference.end(), '\\', '/');
    const auto asWritten = insideFolder(folder, reference);
    if (!asWritten.empty()) return asWritten;
    return insideFolder(folder, std::filesystem::path(reference).filename().string());
}

} // namespace

std::optional<TextureLayer> BumpLayers::layerOf(const MtlBump& bump, std::vector<Finding>& findings) {
    const Image image = imageOf(bump.file, findings);
    if (!image) return std::nullopt;
    const auto say = [&](Severity severity, std::string sentence, std::string remedy) {
        if (!said_.insert(sentence).second) return; // of another surface of the same material
        findings.push_back({severity, "", std::move(sentence), std::move(remedy)});
    };
    if (bump.placed)
        say(Severity::Note, "bump map " + inQuotes(bump.file) + " is scaled or moved by its library",
            "it fills the unit square of the texture coordinates; set its offset and size");
    TextureLayer layer;
    layer.name = image->name();
    layer.pattern.source = TextureSource::Image;
    layer.pattern.image = image;
    layer.pattern.mapping = TextureMapping::UvUnit;
    const double height = bump.multiplier * kTextureHeight.initial;
    layer.strength = kTextureHeight.clamped(height);
    if (layer.strength != height)
        say(Severity::Warning,
            bump.where + ": -bm " + withUnit(bump.multiplier, "") + " would be a height of " +
                withUnit(height, "m") + ", outside " + withUnit(kTextureHeight.minimum, "") + " to " +
                withUnit(kTextureHeight.maximum, "m"),
            "clamped to " + withUnit(layer.strength, "m") + "; lower it, or set the height of the layer");
    say(Severity::Note,
        "bump map " + inQuotes(bump.file) + " has no unit; its height is taken as " +
            withUnit(layer.strength, "m"),
        "set the height of the layer");
    return layer;
}

BumpLayers::Image BumpLayers::imageOf(const std::string& reference, std::vector<Finding>& findings) {
    const auto [known, isNew] = images_.try_emplace(reference);
    if (isNew) known->second = read(reference, findings);
    return known->second;
}

BumpLayers::Image BumpLayers::read(const std::string& reference, std::vector<Finding>& findings) {
    const auto warn = [&](std::string sentence, std::string remedy) {
        findings.push_back({Severity::Warning, "", "bump map " + sentence, std::move(remedy)});
        return nullptr;
    };
    const auto file = fileOf(folder_, reference);
    if (file.empty())
        return warn(inQuotes(reference) + " is not in the folder of the model",
                    "copy it there and open the model again, or choose a picture for the layer");
    if (texels_ > kMaxTexelsOfAModel)
        return warn(inQuotes(reference) + " is one too many: the others fill the memory meant for them",
                    "scale the pictures down");
    const Result<LoadedImage> loaded = readImage(file);
    if (!loaded) return warn(loaded.error().text, "it is left out");
    texels_ += std::size_t(loaded->image->width()) * std::size_t(loaded->image->height());
    if (!loaded->note.empty())
        findings.push_back({Severity::Note, "", loaded->note, "clamped; scale them before saving"});
    return loaded->image;
}

} // namespace tactum
