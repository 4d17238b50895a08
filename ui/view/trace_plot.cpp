#include "ui/view/trace_plot.h"

#include <algorithm>
#include <cmath>

#include <QPainter>
#include <QPainterPath>

#include "ui/base/chart_axis.h"

namespace tactum {

namespace {

/// Time and force to pixels.
class Axes {
public:
    Axes(const QRectF& box, const TouchTrace& rows) : box_(box), start_(rows.front().t) {
        span_ = std::max(rows.back().t - start_, 1e-9);
        double most = 0;
        for (const TouchRow& row : rows)
            most = std::max(most, row.force.norm());
        const double step = tickStep(most > 0 ? most : 1, 4);
        top_ = step * std::max(1.0, std::ceil(most / step + 0.05));
    }

    double x(double t) const { return box_.left() + (t - start_) / span_ * box_.width(); }
    double y(double force) const { return box_.bottom() - force / top_ * box_.height(); }
    const QRectF& box() const { return box_; }
    double start() const { return start_; }
    double span() const { return span_; }
    double top() const { return top_; }

private:
    QRectF box_;
    double start_, span_ = 1, top_ = 1;
};

void drawForceTicks(QPainter& painter, const Axes& axes, const Theme& theme) {
    const double step = tickStep(axes.top(), 5), height = painter.fontMetrics().height();
    for (int i = 0; i * step <= axes.top() * (1 + 1e-9); ++i) {
        const double y = axes.y(i * step);
        painter.setPen(QPen(theme.plotGrid, 1));
        painter.drawLine(QPointF(axes.box().left(), y), QPointF(axes.box().right(), y));
        painter.setPen(theme.textDimmed);
        painter.drawText(QRectF(axes.box().left() - 108, y - height, 100, 2 * height),
                         Qt::AlignRight | Qt::AlignVCenter, tickText(i * step, step));
    }
}

void drawTimeTicks(QPainter& painter, const Axes& axes, const Theme& theme) {
    const double step = tickStep(axes.span(), 10);
    painter.setPen(theme.textDimmed);
    for (double i = std::ceil(axes.start() / step - 1e-9);
         i * step <= axes.start() + axes.span() * (1 + 1e-9); ++i) {
        const double x = axes.x(i * step), y = axes.box().bottom();
        painter.drawLine(QPointF(x, y), QPointF(x, y + 4));
        painter.drawText(QRectF(x - 50, y + 6, 100, 2 * painter.fontMetrics().height()),
                         Qt::AlignHCenter | Qt::AlignTop, tickText(i * step, step));
    }
}

/// A band beneath the curve where something was touched.
void drawContactSpans(QPainter& painter, const Axes& axes, const TouchTrace& rows, const Theme& theme) {
    QColor band = theme.contact;
    band.setAlphaF(0.14f);
    for (std::size_t i = 0, j; i < rows.size(); i = j) {
        for (j = i + 1; j < rows.size() && (rows[j].contacts > 0) == (rows[i].contacts > 0);)
            ++j;
        if (rows[i].contacts == 0) continue;
        const double left = axes.x(rows[i].t), right = axes.x(rows[std::min(j, rows.size() - 1)].t);
        painter.fillRect(QRectF(left, axes.box().top(), std::max(1.0, right - left), axes.box().height()),
                         band);
    }
}

/// Each pixel column shows the least and the largest force that fall into it, so that no peak is lost.
void drawCurve(QPainter& painter, const Axes& axes, const TouchTrace& rows, const Theme& theme) {
    QPainterPath path;
    for (std::size_t i = 0, j; i < rows.size(); i = j) {
        const double x = axes.x(rows[i].t);
        double low = 1e300, high = 0;
        for (j = i; j < rows.size() && axes.x(rows[j].t) < x + 1; ++j) {
            low = std::min(low, rows[j].force.norm());
            high = std::max(high, rows[j].force.norm());
        }
        i == 0 ? path.moveTo(x, axes.y(low)) : path.lineTo(x, axes.y(low));
        path.lineTo(x, axes.y(high));
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.proxy, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
}

} // namespace

void drawForcePlot(QPainter& painter, const QRectF& box, const TouchTrace& rows, const Theme& theme) {
    const double line = painter.fontMetrics().height();
    const Axes axes(box.adjusted(4.2 * line, 2.4 * line, -1.5 * line, -3.4 * line), rows);
    painter.setPen(theme.text);
    painter.drawText(QPointF(axes.box().left(), box.top() + 1.4 * line), "Force on the finger, |F| in N");
    drawContactSpans(painter, axes, rows, theme);
    drawForceTicks(painter, axes, theme);
    drawTimeTicks(painter, axes, theme);
    drawCurve(painter, axes, rows, theme);
    painter.setPen(theme.text);
    painter.drawText(QRectF(axes.box().left(), box.bottom() - 1.7 * line, axes.box().width(), 1.5 * line),
                     Qt::AlignCenter, "time in s");
}

} // namespace tactum
