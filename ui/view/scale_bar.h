// The legend of a colour map: a bar with numbers and their unit. Private to this folder.
#pragma once

#include <QString>

#include "ui/theme.h"
#include "ui/view/felt_options.h"

class QPainter;
class QRectF;
class QSizeF;

namespace tactum {

/// From where to where the colours go, in SI.
struct MapRange {
    double low = 0, high = 1;

    double part(double value) const { return high > low ? (value - low) / (high - low) : 0; }
    bool operator==(const MapRange&) const = default;
};

/// How a value is named and written: shown = factor x value.
struct ValueWords {
    QString name, unit;
    double factor = 1;
};
ValueWords wordsOf(FeltValue value);

/// A range that holds these values and is worth a scale: from 0 where they are all the same.
MapRange rangeOf(double low, double high);

/// Draws it at the right edge of a view, in logical pixels; gives the box that it fills.
QRectF drawScaleBar(QPainter& painter, const QSizeF& view, FeltValue value, const MapRange& range,
                    const Theme& theme);

} // namespace tactum
