#include "ui/view/scale_bar.h"

#include <cmath>

#include <QFontMetricsF>
#include <QObject>
#include <QPainter>

#include "core/surface/material.h"
#include "ui/base/chart_axis.h"
#include "ui/view/colour_map.h"
#include "ui/view/smooth_image.h"

namespace tactum {

namespace {

// Logical pixels.
constexpr double kBarWidth = 16, kMaxHeight = 176, kMinHeight = 60, kBarEdge = 12, kBarPad = 10, kTick = 4,
                 kGap = 8;

const Parameter& parameterOf(FeltValue value) {
    switch (value) {
    case FeltValue::Stiffness:
        return kStiffness;
    case FeltValue::Damping:
        return kDamping;
    case FeltValue::StaticFriction:
        return kStaticFriction;
    case FeltValue::DynamicFriction:
        return kDynamicFriction;
    case FeltValue::Viscosity:
    case FeltValue::Height:
        break;
    }
    return kViscosity;
}

QString figure(double value, double step) {
    return QString::number(value, 'f', std::max(0, int(std::ceil(-std::log10(step) - 1e-9))));
}

void drawBar(QPainter& painter, const QRectF& bar) {
    for (int y = 0; y < int(bar.height()); ++y)
        painter.fillRect(QRectF(bar.left(), bar.bottom() - y - 1, bar.width(), 1.25),
                         mapColour(y / (bar.height() - 1)));
}

} // namespace

ValueWords wordsOf(FeltValue value) {
    if (value == FeltValue::Height) return {QObject::tr("Height of texture"), QStringLiteral("mm"), 1e3};
    const Parameter& parameter = parameterOf(value);
    return {QObject::tr(std::string(parameter.label).c_str()),
            QString::fromUtf8(parameter.unit.data(), int(parameter.unit.size())), 1};
}

MapRange rangeOf(double low, double high, double unit) {
    if (high - low > 1e-9 * std::max(std::abs(low), std::abs(high))) return {low, high};
    if (low == 0) return {0, unit};
    return {std::min(0.0, low), std::max(0.0, low)};
}

QRectF drawScaleBar(QPainter& painter, const QSizeF& view, double taken, FeltValue value,
                    const MapRange& range, const Theme& theme) {
    const ValueWords words = wordsOf(value);
    const QString title =
        words.unit.isEmpty() ? words.name : QStringLiteral("%1, %2").arg(words.name, words.unit);
    const double low = words.factor * range.low, high = words.factor * range.high;
    const QFontMetricsF metrics(painter.font());
    const double line = metrics.height();
    const double around = line + kGap + 2 * kBarPad + 0.5 * line;
    const double bar = std::clamp(view.height() - taken - 2 * kBarEdge - around, kMinHeight, kMaxHeight);
    const double height = bar + around;
    const double step = tickStep(high - low, std::clamp(int(bar / (1.6 * line)), 1, 5));
    double numbers = 0;
    for (double n = std::ceil(low / step - 1e-9); n * step <= high + 1e-9 * step; ++n)
        numbers = std::max(numbers, metrics.horizontalAdvance(figure(n * step, step)));
    const double width =
        std::max(metrics.horizontalAdvance(title), kBarWidth + kTick + 4 + numbers) + 2 * kBarPad;
    const double top = view.height() - kBarEdge - height;
    const QRectF box(kBarEdge, std::round(top), std::ceil(width), std::ceil(height));
    drawSmoothly(painter, box, [&](QPainter& inner) {
        inner.setPen(Qt::NoPen);
        inner.setBrush(theme.label);
        inner.drawRoundedRect(QRectF({0, 0}, box.size()), 6, 6);
        inner.setPen(theme.labelText);
        inner.drawText(QRectF(kBarPad, kBarPad, width - 2 * kBarPad, line), Qt::AlignLeft | Qt::AlignVCenter,
                       title);
        const QRectF strip(kBarPad, kBarPad + line + kGap, kBarWidth, bar);
        drawBar(inner, strip);
        for (double n = std::ceil(low / step - 1e-9); n * step <= high + 1e-9 * step; ++n) {
            const double y = strip.bottom() - (n * step - low) / (high - low) * strip.height();
            inner.setPen(QPen(theme.labelText, 1));
            inner.drawLine(QPointF(strip.right() + 1, y), QPointF(strip.right() + 1 + kTick, y));
            inner.drawText(QRectF(strip.right() + kTick + 5, y - line, numbers + 2, 2 * line),
                           Qt::AlignRight | Qt::AlignVCenter, figure(n * step, step));
        }
    });
    return box;
}

} // namespace tactum
