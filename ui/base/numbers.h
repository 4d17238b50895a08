// Numbers on the screen: always with a decimal point, whatever the user's locale, and in handy units.
#pragma once

#include <optional>

#include <QString>

#include "core/surface/parameter.h"

namespace tactum {

/// "0.60": fixed point in the C locale.
QString numberText(double value, int decimals);
/// How many of `decimals` a value of any size needs: four, fewer where there were more than eight digits, and
/// more where fewer than three were left of it.
int decimalsFor(double value, int decimals);
/// A length of any size in the unit that suits it: "14 µm", "0.30 mm", "200 mm", "4.2 m"; what is no smaller
/// in the unit that the person prefers, where that is another than millimetres.
QString lengthText(double metres);
/// The same of an area: "0.25 mm²", "52 cm²", "1.20 m²".
QString areaText(double squareMetres);
/// A time left: "3 s", "2 min".
QString durationText(double seconds);

/// How a parameter is shown: metres and N/m as the person prefers, at first as millimetres; kg as g, rad as
/// degrees, everything else in its own unit.
struct DisplayUnit {
    double factor = 1; ///< shown = factor x value
    QString name;
    int decimals = 0;
};
/// Thread: ui.
DisplayUnit displayUnit(const Parameter& parameter);

/// Reads what a person typed: a number in the C locale, a comma taken as the point, and after it any unit of
/// the same kind as `unit`, in which the number comes back: "1.2 N/mm" of N/m is 1200. A number alone is in
/// `unit`. Empty when it is no finite number or the unit is of another kind.
std::optional<double> readNumber(const QString& typed, const QString& unit = {});

} // namespace tactum
