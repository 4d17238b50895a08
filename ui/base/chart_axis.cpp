#include "ui/base/chart_axis.h"

#include <algorithm>
#include <cmath>

#include <QPainter>

#include "ui/base/numbers.h"
#include "ui/base/style.h"

namespace tactum {

double tickStep(double range, int most) {
    const double power = std::pow(10, std::floor(std::log10(range / most)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (range / (factor * power) <= most * (1 + 1e-9)) return factor * power;
    return 10 * power;
}

QString tickText(double value, double step) {
    return numberText(value, std::max(0, int(std::ceil(-std::log10(step) - 1e-9))));
}

void drawGridLine(QPainter& painter, const QRectF& area, double y, const QString& figure) {
    constexpr double kWidth = 48, kGap = 6, kHeight = 16; // logical pixels
    const double at = std::round(y) + 0.5;
    painter.setPen(QPen(theme().plotGrid, 1));
    painter.drawLine(QPointF(area.left(), at), QPointF(area.right(), at));
    painter.setPen(theme().textDimmed);
    painter.drawText(QRectF(area.left() - kGap - kWidth, at - kHeight / 2, kWidth, kHeight),
                     Qt::AlignRight | Qt::AlignVCenter, figure);
}

void drawChartHint(QPainter& painter, const QRectF& rect, const QString& hint) {
    painter.setPen(theme().textDimmed);
    painter.drawText(rect.adjusted(8, 4, -8, -4), int(Qt::AlignCenter) | Qt::TextWordWrap, hint);
}

} // namespace tactum
