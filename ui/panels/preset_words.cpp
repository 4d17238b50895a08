#include "ui/panels/preset_words.h"

#include "ui/base/numbers.h"
#include "ui/base/style.h"
#include "ui/base/words.h"
#include "ui/document/preset_store.h"
#include "ui/panels/preset_library.h"

namespace tactum {

namespace {

/// "staticFriction": the key under which a preset says the source of a value.
QString sourceKey(const Parameter& parameter) {
    QString key;
    for (const QString& part : asIs(parameter.key).split(u'-'))
        key += key.isEmpty() ? part : part.left(1).toUpper() + part.mid(1);
    return key;
}

QString valueText(const Parameter& parameter, double value) {
    const DisplayUnit unit = displayUnit(parameter);
    const QString number = numberText(unit.factor * value, unit.decimals);
    return unit.name.isEmpty() ? number : number + u' ' + unit.name;
}

QString sourceText(const PresetSource& source) {
    if (source.words.empty() && source.link.empty()) return PresetLibrary::tr("no source given");
    QString text = asIs(source.words).toHtmlEscaped();
    if (source.typical) text = PresetLibrary::tr("typical; tables disagree. %1").arg(text);
    const QString link = asIs(source.link);
    const bool isAddress =
        link.startsWith(QStringLiteral("https://")) || link.startsWith(QStringLiteral("http://"));
    if (isAddress)
        text +=
            QStringLiteral(" <a href=\"%1\">%2</a>").arg(link.toHtmlEscaped(), PresetLibrary::tr("source"));
    else if (!link.isEmpty())
        text += u' ' + link.toHtmlEscaped();
    return text;
}

QString libraryLine(const QString& label, const QString& value, const PresetSource& source) {
    return QStringLiteral("<p style='margin:0 0 4px 0'>%1 <b>%2</b><br><span style='color:%3'>%4</span></p>")
        .arg(label.toHtmlEscaped(), value.toHtmlEscaped(), theme().textDimmed.name(), sourceText(source));
}

} // namespace

QString figuresOf(const StoredPreset& stored) {
    const Preset& preset = stored.preset;
    QStringList figures;
    for (std::size_t i = 0; i < kMaterialFields.size(); ++i) {
        const Parameter* parameter = kMaterialFields[i].parameter;
        if (preset.values[i] && (parameter == &kStaticFriction || parameter == &kDynamicFriction))
            figures << QString::number(*preset.values[i], 'g', 3);
    }
    for (std::size_t i = 0; i < kMaterialFields.size() && figures.isEmpty(); ++i)
        if (preset.values[i]) figures << valueText(*kMaterialFields[i].parameter, *preset.values[i]);
    if (figures.isEmpty() && preset.layers) figures << PresetLibrary::tr("texture");
    QStringList parts{figures.join(QStringLiteral(" / "))};
    if (!preset.category.empty()) parts << stored.category();
    return parts.join(QStringLiteral(" \u00b7 "));
}

QString detailsOf(const StoredPreset& stored) {
    const Preset& preset = stored.preset;
    QString text;
    if (!preset.category.empty())
        text = QStringLiteral("<p style='margin:0 0 4px 0'><b>%1</b></p>")
                   .arg(stored.category().toHtmlEscaped());
    for (std::size_t i = 0; i < kMaterialFields.size(); ++i) {
        const Parameter& parameter = *kMaterialFields[i].parameter;
        if (preset.values[i])
            text += libraryLine(wordsOf(parameter.label), valueText(parameter, *preset.values[i]),
                                sourceOf(preset, sourceKey(parameter).toStdString()));
    }
    if (preset.shading)
        text += libraryLine(PresetLibrary::tr("Force shading"),
                            preset.shading->on ? PresetLibrary::tr("on") : PresetLibrary::tr("off"),
                            sourceOf(preset, kShadingPart));
    if (!preset.layers) return text;
    QStringList names;
    for (const TextureLayer& layer : *preset.layers)
        names << QStringLiteral("%1 (%2, %3)")
                     .arg(asIs(layer.name), wordsOf(kTextureSources[std::size_t(layer.pattern.source)].label),
                          valueText(strengthParameter(layer.target), layer.strength));
    return text + libraryLine(PresetLibrary::tr("Layers"),
                              names.isEmpty() ? PresetLibrary::tr("none") : names.join(QStringLiteral(", ")),
                              sourceOf(preset, kLayersPart));
}

QString tipOf(const StoredPreset& stored) {
    return QStringLiteral("<p style='margin:0 0 4px 0'><b>%1</b></p>").arg(stored.name().toHtmlEscaped()) +
           detailsOf(stored);
}

} // namespace tactum
