#include "ui/base/numbers.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/numbers.h"
#include "core/scene/placing.h"
#include "ui/base/preferences.h"
#include "ui/base/units.h"
#include "ui/base/words.h"

namespace tactum {

namespace {

/// As the person prefers; decimals: how many fewer than of metres.
DisplayUnit lengthUnit() {
    const LengthUnit& unit = kLengthUnits[std::size_t(Preferences::instance().value(Preferred::Lengths))];
    return {1 / unit.metres, asIs(unit.name), int(std::lround(-std::log10(unit.metres)))};
}

bool showsNewtonsPerMillimetre() {
    return Preferences::instance().value(Preferred::Stiffnesses) == 1;
}

} // namespace

QString numberText(double value, int decimals) {
    if (!std::isfinite(value)) return QStringLiteral("-");
    const QString text = QString::number(value, 'f', decimals);
    const bool minusZero = text.startsWith(u'-') && std::abs(value) < 0.5 * std::pow(10.0, -decimals);
    return minusZero ? text.mid(1) : text;
}

int decimalsFor(double value, int decimals) {
    if (!(std::abs(value) > 0)) return std::min(decimals, 4);
    const int power = int(std::floor(std::log10(std::abs(value))));
    return std::clamp(2 - power, std::min(decimals, std::clamp(7 - power, 0, 4)), decimals);
}

QString lengthText(double metres) {
    // Of less than a tenth of a millimetre no two digits would be left.
    for (const auto& [unit, name] :
         {std::pair(1e-6, QStringLiteral(" \u00b5m")), {1e-9, QStringLiteral(" nm")}})
        if (metres >= unit / 10 && metres < 0.995e-4) {
            const double value = metres / unit;
            return numberText(value, value < 0.995 ? 2 : value < 9.95 ? 1 : 0) + name;
        }
    if (const DisplayUnit unit = lengthUnit(); unit.name != QLatin1String("mm")) {
        const double shown = unit.factor * metres;
        return numberText(shown, shown < 9.995 ? 2 : shown < 99.95 ? 1 : 0) + u' ' + unit.name;
    }
    if (metres < 0.01) return numberText(1e3 * metres, 2) + QStringLiteral(" mm");
    if (metres < 1) return numberText(1e3 * metres, 0) + QStringLiteral(" mm");
    return numberText(metres, metres < 10 ? 1 : 0) + QStringLiteral(" m");
}

QString areaText(double squareMetres) {
    const auto figures = [](double value, const QString& unit) {
        return numberText(value, value < 9.95 ? 2 : value < 99.5 ? 1 : 0) + unit;
    };
    if (squareMetres < 0.995e-4) return figures(1e6 * squareMetres, QStringLiteral(" mm\u00b2"));
    if (squareMetres < 0.995) return figures(1e4 * squareMetres, QStringLiteral(" cm\u00b2"));
    return figures(squareMetres, QStringLiteral(" m\u00b2"));
}

QString durationText(double seconds) {
    if (seconds < 90) return numberText(std::max(1.0, seconds), 0) + QStringLiteral(" s");
    return numberText(seconds / 60, 0) + QStringLiteral(" min");
}

DisplayUnit displayUnit(const Parameter& parameter) {
    if (parameter.unit == "m") {
        const DisplayUnit unit = lengthUnit();
        return {unit.factor, unit.name, std::max(0, parameter.decimals - unit.decimals)};
    }
    if (parameter.unit == "N/m" && showsNewtonsPerMillimetre())
        return {1e-3, QStringLiteral("N/mm"), parameter.decimals + 3};
    if (parameter.unit == "kg") return {1e3, QStringLiteral("g"), std::max(0, parameter.decimals - 3)};
    if (parameter.unit == "rad")
        return {180 / std::numbers::pi, QStringLiteral("\u00b0"), std::max(0, parameter.decimals - 2)};
    return {1, asIs(parameter.unit), parameter.decimals};
}

std::optional<double> readNumber(const QString& typed, const QString& unit) {
    // The longest beginning that is a number: "1e-3 m" has its e in the number, "3 mm" ends before its m.
    QString text = typed.trimmed();
    text.replace(u',', u'.');
    for (qsizetype length = text.size(); length > 0; --length) {
        const auto number = parseNumber(text.left(length).trimmed().toStdString());
        if (!number) continue;
        const auto own = readUnit(unit), typedUnit = readUnit(QStringView(text).mid(length).trimmed());
        if (text.mid(length).trimmed().isEmpty()) return number;
        if (!typedUnit || !own || typedUnit->dimension != own->dimension) return std::nullopt;
        return *number * (typedUnit->factor / own->factor);
    }
    return std::nullopt;
}

} // namespace tactum
