// Where something small stands in a corner that may be covered. Private to this folder.
#pragma once

#include <algorithm>

#include <QRectF>
#include <QRegion>

namespace tactum {

/// The place, or below what covers it in a view so high; itself where nothing is free. What begins lower
/// makes room itself, as the loupe does. Logical pixels.
inline QRectF belowCovers(const QRectF& corner, double height, const QRegion& covered) {
    constexpr double kApart = 8;
    QRectF place = corner;
    while (place.bottom() <= height) {
        double top = place.top();
        for (const QRect& part : covered)
            if (QRectF(part).intersects(place) && part.top() < place.center().y())
                top = std::max(top, QRectF(part).bottom() + kApart);
        if (top == place.top()) return place;
        place.moveTop(top);
    }
    return corner;
}

} // namespace tactum
