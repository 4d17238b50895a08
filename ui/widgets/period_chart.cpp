#include "ui/widgets/period_chart.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include "ui/base/chart_axis.h"
#include "ui/base/numbers.h"
#include "ui/base/style.h"

namespace tactum {

namespace {

constexpr std::size_t kBins = PeriodHistogram::kBounds.size() + 1;
constexpr double kDecades = 5; // from all ticks down to one in a hundred thousand
/// Of the upper ends of bins.
constexpr std::pair<std::size_t, const char*> kLabels[] = {
    {0, "2 \u00b5s"}, {3, "20"}, {6, "200"}, {9, "2 ms"}};
static_assert(PeriodHistogram::kBounds[0] == 2 && PeriodHistogram::kBounds[9] == 2000);

/// 0 to 1, of a share of the ticks.
double heightOf(double share) {
    return share > 0 ? std::clamp(1 + std::log10(share) / kDecades, 0.0, 1.0) : 0;
}

QString percent(double share) {
    return numberText(100 * share, share < 1e-3 ? 3 : share < 0.1 ? 1 : 0) + QStringLiteral(" %");
}

} // namespace

PeriodChart::PeriodChart(QWidget* parent)
    : Chart(QStringLiteral("health-periods"), tr("Deviations of the servo's period"), {40, 7, 4, 16},
            parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void PeriodChart::setPeriods(const PeriodHistogram& periods, double period) {
    periods_ = periods;
    period_ = period;
    all_ = std::accumulate(periods.count.begin(), periods.count.end(), 0.0);
    update();
}

double PeriodChart::share(std::size_t bin) const {
    return all_ > 0 ? periods_.count[bin] / all_ : 0;
}

QString PeriodChart::figuresOf(std::size_t bin) const {
    const auto& bounds = PeriodHistogram::kBounds;
    const QString from = bin == 0 ? QStringLiteral("0") : numberText(bounds[bin - 1], 0);
    const QString range = bin == bounds.size() ? tr("more than %1 \u00b5s").arg(from)
                                               : tr("%1 to %2 \u00b5s").arg(from, numberText(bounds[bin], 0));
    return tr("%1: %n tick(s), %2", nullptr, int(periods_.count[bin])).arg(range, percent(share(bin)));
}

double PeriodChart::edge(std::size_t bin) const {
    return area().left() + area().width() * double(bin) / double(kBins);
}

void PeriodChart::paintChart(QPainter& painter) const {
    painter.setRenderHint(QPainter::Antialiasing, false); // bars end between pixels
    paintGrid(painter);
    paintBars(painter);
    paintPeriod(painter);
}

void PeriodChart::paintGrid(QPainter& painter) const {
    const QRectF a = area();
    const std::pair<double, QString> lines[] = {{1, tr("100 %")}, {1e-2, tr("1 %")}, {1e-4, tr("0.01 %")}};
    for (const auto& [share, label] : lines)
        drawGridLine(painter, a, a.bottom() - heightOf(share) * a.height(), label);
    for (const auto& [bin, label] : kLabels) {
        const double x = edge(bin + 1);
        painter.drawText(QRectF(x - 32, a.bottom() + 2, 64, 14), Qt::AlignHCenter | Qt::AlignTop,
                         QString::fromUtf8(label));
    }
    painter.setPen(theme().border);
    painter.drawLine(a.bottomLeft(), a.bottomRight());
}

void PeriodChart::paintBars(QPainter& painter) const {
    const QRectF a = area();
    for (std::size_t bin = 0; bin < kBins; ++bin) {
        if (periods_.count[bin] == 0) continue;
        const double high = std::max(2.0, heightOf(share(bin)) * a.height());
        const bool late = bin > 0 && PeriodHistogram::kBounds[bin - 1] >= period_;
        painter.fillRect(QRectF(edge(bin) + 1, a.bottom() - high, edge(bin + 1) - edge(bin) - 2, high),
                         late ? theme().fault : theme().accent);
    }
}

void PeriodChart::paintPeriod(QPainter& painter) const {
    const auto& bounds = PeriodHistogram::kBounds;
    const auto bin = std::size_t(std::lower_bound(bounds.begin(), bounds.end(), period_) - bounds.begin());
    const double x = std::round(edge(bin + 1)) + 0.5;
    painter.setPen(QPen(theme().fault, 1, Qt::DashLine));
    painter.drawLine(QPointF(x, area().top() - 5), QPointF(x, area().bottom()));
    painter.setPen(theme().fault);
    painter.drawText(QRectF(x + 4, area().top() - 8, 48, 14), Qt::AlignLeft | Qt::AlignVCenter, tr("late"));
}

bool PeriodChart::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const double part = (help->pos().x() - area().left()) / area().width();
    const QString figures = part >= 0 && part < 1
                                ? figuresOf(std::size_t(part * double(kBins))) + QStringLiteral("<br>")
                                : QString();
    QToolTip::showText(help->globalPos(), QStringLiteral("<p>%1%2</p>").arg(figures, toolTip()), this);
    return true;
}

} // namespace tactum
