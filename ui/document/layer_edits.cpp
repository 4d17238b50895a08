#include "ui/document/layer_edits.h"

#include <algorithm>
#include <cmath>

#include <QFileInfo>

#include "core/surface/texture_matters.h"
#include "ui/base/numbers.h"
#include "ui/base/words.h"

namespace tactum {

namespace {

/// Widths of a repeat that show what the pattern is, m.
double firstSize(TextureSource source) {
    switch (source) {
    case TextureSource::Grooves:
    case TextureSource::Weave:
        return 2e-3;
    case TextureSource::Dots:
        return 3e-3;
    case TextureSource::Image:
        return 0.03;
    default:
        return kTextureSize.initial;
    }
}

std::string firstName(TextureSource source, const TextureImage* image) {
    if (image && !image->name().empty())
        return QFileInfo(QString::fromStdString(image->name())).completeBaseName().toStdString();
    return std::string(kTextureSources[std::size_t(source)].label);
}

bool isHeight(TextureTarget target) {
    return target == TextureTarget::Height;
}

} // namespace

std::string freshLayerName(const TextureLayers& among, const std::string& wanted) {
    // "Noise 2" once more is "Noise 3", not "Noise 2 2".
    const std::size_t end = wanted.find_last_not_of("0123456789");
    const bool numbered =
        end != std::string::npos && end > 0 && wanted[end] == ' ' && end + 1 < wanted.size();
    const std::string word = numbered ? wanted.substr(0, end) : wanted;
    std::string name = wanted;
    for (int number = 2; std::ranges::find(among, name, &TextureLayer::name) != among.end(); ++number)
        name = word + " " + std::to_string(number);
    return name;
}

TextureLayer newLayer(TextureSource source, const TextureLayers& among, bool hasUvs,
                      std::shared_ptr<const TextureImage> image) {
    TextureLayer layer;
    layer.name = freshLayerName(among, firstName(source, image.get()));
    layer.pattern.source = source;
    layer.pattern.size = firstSize(source);
    if (source == TextureSource::Image && hasUvs) layer.pattern.mapping = TextureMapping::UvUnit;
    layer.pattern.image = std::move(image);
    return layer;
}

TextureLayer withTarget(TextureLayer layer, TextureTarget target) {
    if (isHeight(layer.target) != isHeight(target))
        layer.strength = std::copysign(strengthParameter(target).initial, layer.strength);
    layer.target = target;
    layer.ownPlane = layer.ownPlane && isHeight(target); // nothing else can have one
    return layer;
}

void moveLayer(TextureLayers& layers, int from, int to) {
    const auto at = layers.begin();
    if (from < to) std::rotate(at + from, at + from + 1, at + to + 1);
    if (from > to) std::rotate(at + to, at + from, at + from + 1);
}

std::optional<int> followed(const TextureLayers& now, std::size_t countBefore, int number,
                            const TextureLayer& before) {
    const bool isThere = number < int(now.size());
    if (isThere && now[std::size_t(number)] == before) return number;
    if (const auto found = std::ranges::find(now, before); found != now.end())
        return int(found - now.begin());
    return isThere && now.size() == countBefore ? std::optional(number) : std::nullopt;
}

TextureLayers alone(TextureLayers layers, int number) {
    for (int i = 0; i < int(layers.size()); ++i)
        layers[std::size_t(i)].enabled = i == number;
    return layers;
}

bool hasFrame(const TexturePattern& pattern) {
    return pattern.source != TextureSource::Painted && !usesUvs(pattern);
}

bool isPicture(const QString& file) {
    const QString ending = QFileInfo(file).suffix().toLower();
    return QStringList{"png", "jpg", "jpeg", "tif", "tiff"}.contains(ending);
}

QString strengthText(TextureTarget target, double strength) {
    if (isHeight(target)) {
        const DisplayUnit unit = displayUnit(kTextureHeight);
        return numberText(unit.factor * strength, unit.decimals) + u' ' + unit.name;
    }
    const QString percent = numberText(100 * strength, 0) + QStringLiteral(" %");
    return strength > 0 ? u'+' + percent : percent;
}

QString targetText(const TextureLayer& layer) {
    const QString target = labelOf(kTextureTargets[std::size_t(layer.target)]);
    return strengthMatters(layer) ? target + u' ' + strengthText(layer.target, layer.strength)
                                  : QObject::tr("%1 multiplied").arg(target);
}

QString labelOf(const NamedChoice& choice) {
    return wordsOf(choice.label);
}

} // namespace tactum
