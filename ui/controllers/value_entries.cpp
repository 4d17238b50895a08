#include "ui/controllers/value_entries.h"

#include <algorithm>

#include <QRegularExpression>

#include "ui/base/numbers.h"
#include "ui/document/document.h"

namespace tactum {

namespace {

/// "static friction" and "0.3".
struct TypedValue {
    QStringList words;
    QString number;
};

std::optional<TypedValue> valueIn(const QString& typed) {
    static const QRegularExpression form(QStringLiteral(R"(^\s*([^\d]*[^\d\s.,+-])\s+([+-]?[.,]?\d.*)$)"));
    const auto match = form.match(typed);
    if (!match.hasMatch()) return std::nullopt;
    return TypedValue{match.captured(1).toCaseFolded().split(u' ', Qt::SkipEmptyParts), match.captured(2)};
}

bool means(const QStringList& words, const QString& label) {
    const QStringList own = label.toCaseFolded().split(u' ');
    return std::ranges::all_of(words, [&](const QString& word) {
        return std::ranges::any_of(own, [&](const QString& each) { return each.startsWith(word); });
    });
}

QString withUnit(const QString& number, const DisplayUnit& unit) {
    return unit.name.isEmpty() ? number : number + u' ' + unit.name;
}

/// A row of the table with a number of its own unit, or why there is none.
PaletteEntry entryFor(const Parameter& parameter, const QString& number, const QString& goal,
                      const std::function<void(double)>& set) {
    const DisplayUnit unit = displayUnit(parameter);
    const auto shown = [&](double value) {
        return numberText(unit.factor * value, decimalsFor(unit.factor * value, unit.decimals));
    };
    const QString label = QObject::tr(parameter.label.data());
    const auto read = readNumber(number, unit.name);
    PaletteEntry entry;
    entry.menu = QObject::tr("Value");
    entry.sentence = QObject::tr(parameter.sentence.data());
    entry.text = QObject::tr("%1: %2 %3")
                     .arg(label, read ? withUnit(shown(*read / unit.factor), unit) : number, goal)
                     .trimmed();
    if (!read)
        entry.whyNot = unit.name.isEmpty() ? QObject::tr("%1 is a mere number.").arg(label)
                                           : QObject::tr("%1 is measured in %2.").arg(label, unit.name);
    else if (!parameter.allows(*read / unit.factor))
        entry.whyNot = QObject::tr("%1 goes from %2 to %3.")
                           .arg(label, shown(parameter.minimum), withUnit(shown(parameter.maximum), unit));
    else
        entry.run = [set, value = *read / unit.factor] { set(value); };
    return entry;
}

QString goalText(const Document& document, const SurfaceRefs& surfaces) {
    if (surfaces.size() == 1)
        return QObject::tr("on %1").arg(QString::fromStdString(document.surface(surfaces.front())->name));
    return QObject::tr("on %1 surfaces").arg(surfaces.size());
}

} // namespace

std::vector<PaletteEntry> valueEntries(Document& document, const QString& typed) {
    const auto value = valueIn(typed);
    if (!value) return {};
    SurfaceRefs surfaces = document.selected();
    const std::size_t selected = surfaces.size();
    std::erase_if(surfaces, [&](SurfaceRef ref) { return document.surface(ref)->locked; });
    const QString why = !surfaces.empty() ? QString()
                        : selected > 0    ? QObject::tr("What is selected is locked.")
                                          : QObject::tr("No surface is selected.");
    std::vector<PaletteEntry> entries;
    for (const MaterialField& field : kMaterialFields) {
        if (!means(value->words, QObject::tr(field.parameter->label.data()))) continue;
        entries.push_back(entryFor(*field.parameter, value->number,
                                   why.isEmpty() ? goalText(document, surfaces) : QString(),
                                   [&document, surfaces, &field](double number) {
                                       document.setMaterialValue(surfaces, field, number);
                                   }));
        if (!why.isEmpty()) entries.back().whyNot = why;
    }
    if (means(value->words, QObject::tr(kProxyRadius.label.data())))
        entries.push_back(entryFor(kProxyRadius, value->number, {},
                                   [&document](double number) { document.setProxyRadius(number); }));
    return entries;
}

} // namespace tactum
