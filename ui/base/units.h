// Units that a person may type after a number: "1.2 N/mm", "0.3 mm", "40 deg", "50 %".
#pragma once

#include <array>
#include <optional>

#include <QStringView>

namespace tactum {

/// A product of powers of the SI's units; angles and ratios are plain numbers.
struct Unit {
    double factor = 1;                        ///< of one of it in kilograms, metres and seconds
    std::array<int, 3> dimension = {0, 0, 0}; ///< powers of kg, m and s
};

/// Products of N, m, g, s, Hz, rad, deg, ° and %, with the prefixes n, u, µ, m, c and k, joined by spaces, *
/// or ·; what follows a / divides; powers as ^2, ² and ³. Nothing for what is none; the empty text is 1.
std::optional<Unit> readUnit(QStringView text);

} // namespace tactum
