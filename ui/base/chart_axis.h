// What the charts have in common: round steps, lines of a grid with their figures, a sentence where there is
// no data.
#pragma once

#include <QRectF>
#include <QString>

class QPainter;

namespace tactum {

/// A step of 1, 2 or 5 times a power of ten that divides `range` (> 0) into at most `most` (> 0) parts.
double tickStep(double range, int most);
/// A figure of an axis with such steps, with as many digits as tell them apart.
QString tickText(double value, double step);
/// A line over the whole area, and its figure left of it.
void drawGridLine(QPainter& painter, const QRectF& area, double y, const QString& figure);
/// In the place of a chart.
void drawChartHint(QPainter& painter, const QRectF& rect, const QString& hint);

} // namespace tactum
