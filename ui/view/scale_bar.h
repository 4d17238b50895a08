// The legend of a colour map: a bar with numbers and their unit. Private to this folder.
#pragma once

#include <QString>

#include "ui/base/theme.h"
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

/// A range that holds these values and is worth a scale: from 0 where they are all the same, and to `unit`
/// where that is 0.
MapRange rangeOf(double low, double high, double unit = 1);

/// Draws it into the lower left corner of a view, in logical pixels, below what fills the corner down to
/// `taken`; gives the box that it fills.
QRectF drawScaleBar(QPainter& painter, const QSizeF& view, double taken, FeltValue value,
                    const MapRange& range, const Theme& theme);

} // namespace tactum
