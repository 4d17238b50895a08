#include "ui/widgets/compare_chart.h"

#include <algorithm>
#include <cmath>

#include <QPainter>

#include "ui/base/chart_axis.h"
#include "ui/base/numbers.h"
#include "ui/base/style.h"

namespace tactum {

namespace {

constexpr double kMin = 0.1; // N, end of the axis
constexpr int kLines = 4;    // above zero, at most

} // namespace

CompareChart::CompareChart(QWidget* parent)
    : Chart(QStringLiteral("compare-chart"), tr("Force of the stroke in both states"), {48, 28, 12, 20},
            parent) {}

void CompareChart::show(std::shared_ptr<const TouchTrace> a, std::shared_ptr<const TouchTrace> b) {
    a_ = std::move(a);
    b_ = std::move(b);
    update();
}

std::vector<double> CompareChart::columnsOf(const TouchTrace& rows, int count) const {
    std::vector<double> largest(std::size_t(count), 0.0);
    const double begin = rows.front().t, seconds = std::max(rows.back().t - begin, 1e-9);
    for (const TouchRow& row : rows) {
        const auto column = std::min(std::size_t((row.t - begin) / seconds * count), largest.size() - 1);
        largest[column] = std::max(largest[column], row.force.norm());
    }
    // A column that no step falls into goes on from the one before.
    std::vector<bool> filled(largest.size(), false);
    for (const TouchRow& row : rows)
        filled[std::min(std::size_t((row.t - begin) / seconds * count), largest.size() - 1)] = true;
    for (std::size_t i = 1; i < largest.size(); ++i)
        if (!filled[i]) largest[i] = largest[i - 1];
    return largest;
}

void CompareChart::paintChart(QPainter& painter) const {
    const QRectF place = area();
    const int count = std::clamp(int(place.width()), 2, 4000);
    const std::vector<double> a = columnsOf(*a_, count), b = columnsOf(*b_, count);
    const double most = std::max({kMin, *std::ranges::max_element(a), *std::ranges::max_element(b)});
    const double step = tickStep(most, kLines), top = step * std::ceil(most / step - 1e-9);
    paintAxes(painter, top, step, b_->back().t - b_->front().t);
    const auto lineOf = [&](const std::vector<double>& columns) {
        QPolygonF line;
        for (std::size_t i = 0; i < columns.size(); ++i)
            line << QPointF(place.left() + double(i) / (count - 1) * place.width(),
                            place.bottom() - columns[i] / top * place.height());
        return line;
    };
    const QPolygonF lineA = lineOf(a), lineB = lineOf(b);
    QPolygonF between = lineA;
    for (auto point = lineB.rbegin(); point != lineB.rend(); ++point)
        between << *point;
    QColor shade = theme().proxy;
    shade.setAlphaF(0.2f);
    painter.setPen(Qt::NoPen);
    painter.setBrush(shade);
    painter.drawPolygon(between);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme().proxy, 1.75));
    painter.drawPolyline(lineB);
    painter.setPen(QPen(theme().text, 1.25, Qt::DashLine));
    painter.drawPolyline(lineA);
    paintLegend(painter);
}

void CompareChart::paintAxes(QPainter& painter, double top, double step, double seconds) const {
    const QRectF place = area();
    for (int i = 0; i * step <= top * (1 + 1e-9); ++i)
        drawGridLine(painter, place, place.bottom() - place.height() * i * step / top,
                     i == 0 ? tr("0 N") : tickText(i * step, step));
    painter.drawText(QRectF(place.left(), place.bottom() + 2, place.width(), 16), Qt::AlignLeft,
                     QStringLiteral("0 s"));
    painter.drawText(QRectF(place.left(), place.bottom() + 2, place.width(), 16), Qt::AlignRight,
                     tr("%1 s").arg(numberText(seconds, 2)));
}

void CompareChart::paintLegend(QPainter& painter) const {
    double x = area().left();
    const auto entry = [&](const QString& word, const QPen& pen) {
        painter.setPen(pen);
        painter.drawLine(QPointF(x, 12), QPointF(x + 18, 12));
        painter.setPen(theme().textDimmed);
        painter.drawText(QPointF(x + 24, 16), word);
        x += 24 + painter.fontMetrics().horizontalAdvance(word) + 2 * kRhythm;
    };
    entry(tr("A: as marked"), QPen(theme().text, 1.25, Qt::DashLine));
    entry(tr("B: as it is now"), QPen(theme().proxy, 1.75));
}

} // namespace tactum
