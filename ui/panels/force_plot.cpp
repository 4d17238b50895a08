#include "ui/panels/force_plot.h"

#include <algorithm>
#include <cmath>

#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>

#include "ui/numbers.h"
#include "ui/style.h"

namespace tactum {

namespace {

constexpr double kSpan = 6;          // s, width of the chart
constexpr double kSampleTime = 0.01; // s, ticks of this long are one sample
constexpr double kSlipSpeed = 2e-3;  // m/s; a proxy that sticks to a model at rest does not move at all

/// The force along the surfaces: what is left of it without the share of the normals that push.
double tangentialForce(const HapticOutput& out) {
    Vec3 rest = out.force;
    for (int i = 0; i < std::min(out.contacts, kMaxModelPlanes); ++i) {
        const Vec3& normal = out.contact[std::size_t(i)].normal;
        rest -= std::max(0.0, rest.dot(normal)) * normal;
    }
    return out.contacts > 0 ? rest.norm() : 0;
}

/// Ends of the axis, in N; a grid line at each `step`.
struct Axis {
    double top, step;
};
constexpr Axis kAxes[] = {{1, 0.25}, {2, 0.5}, {3, 1}, {5, 1}, {8, 2}, {12, 4}, {20, 5}, {40, 10}};

Axis axisFor(double newton) {
    for (const Axis& axis : kAxes)
        if (newton <= axis.top) return axis;
    return {newton, newton / 4};
}

} // namespace

ForcePlot::ForcePlot(QWidget* parent) : QWidget(parent), pause_(new QToolButton) {
    setObjectName(QStringLiteral("force-plot"));
    setAccessibleName(tr("Force over time"));
    addPauseButton();
}

void ForcePlot::addPauseButton() {
    pause_->setObjectName(QStringLiteral("plot-pause"));
    pause_->setCheckable(true);
    pause_->setToolTip(tr("Hold the chart still"));
    pause_->setAccessibleName(tr("Pause the force plot"));
    pause_->setIconSize({16, 16});
    connect(pause_, &QToolButton::toggled, this, &ForcePlot::setPaused);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, kRhythm, 0);
    row->addWidget(pause_, 0, Qt::AlignTop | Qt::AlignRight);
    refreshIcon();
}

void ForcePlot::refreshIcon() {
    pause_->setIcon(icon(paused_ ? QStringLiteral("play") : QStringLiteral("pause"), theme().text));
}

void ForcePlot::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) refreshIcon();
    QWidget::changeEvent(event);
}

void ForcePlot::take(Engine& engine) {
    fresh_.clear();
    TracePoint point;
    while (engine.popTrace(point))
        if (!paused_) fresh_.push_back(point);
    take(fresh_, engine.proxy().output, engine.device().maxForce);
}

void ForcePlot::clear() {
    samples_.clear();
    ticks_ = 0;
    tangential_ = 0;
    update();
}

void ForcePlot::take(const std::vector<TracePoint>& points, const HapticOutput& touch, double limit) {
    limit_ = std::max(limit, 0.1);
    if (paused_) return;
    // Ticks carry no normals, and an old normal makes a wrong tangential force where the surface is bent:
    // between the reports of two frames it is interpolated.
    const double before = tangential_;
    tangential_ = tangentialForce(touch);
    for (std::size_t i = 0; i < points.size(); ++i)
        add(points[i], std::lerp(before, tangential_, double(i + 1) / double(points.size())),
            touch.contacts > 0);
    fitAxis();
    update();
}

void ForcePlot::setPaused(bool paused) {
    paused_ = paused;
    pause_->setChecked(paused);
    refreshIcon();
    update();
}

void ForcePlot::add(const TracePoint& point, double tangential, bool touching) {
    if (ticks_++ == 0) building_ = {.t = point.t, .proxy = point.proxy};
    building_.force = std::max(building_.force, point.force.norm());
    building_.tangential = std::max(building_.tangential, tangential);
    building_.touching = touching;
    const double duration = point.t - building_.t;
    if (duration < kSampleTime) return;
    // From where the proxy was at each tick: a slip is often over before the next frame could see it.
    building_.slipping = building_.touching && (point.proxy - building_.proxy).norm() > kSlipSpeed * duration;
    samples_.push_back(building_);
    ticks_ = 0;
    while (samples_.back().t - samples_.front().t > kSpan)
        samples_.pop_front();
}

void ForcePlot::fitAxis() {
    double peak = 0;
    for (const Sample& s : samples_)
        peak = std::max(peak, s.force);
    // Near the limit the axis reaches beyond it, so that the distance to it can be seen.
    top_ = peak > 0.6 * limit_ ? 1.1 * limit_ : std::min(axisFor(1.1 * peak).top, 1.1 * limit_);
}

QRectF ForcePlot::area() const {
    return QRectF(rect()).adjusted(44, 28, -5 * kRhythm, -12);
}

QPointF ForcePlot::at(double t, double newton) const {
    const QRectF a = area();
    const double end = samples_.empty() ? 0 : samples_.back().t;
    return {a.right() - (end - t) / kSpan * a.width(), a.bottom() - newton / top_ * a.height()};
}

void ForcePlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), theme().panel);
    paintGrid(painter);
    paintLimit(painter);
    paintForce(painter);
    paintTangential(painter);
    paintLegend(painter);
}

void ForcePlot::paintGrid(QPainter& painter) const {
    const QRectF a = area();
    painter.setFont(figureFont(-1));
    const double step = axisFor(top_).step;
    const bool limitShown = limit_ <= top_;
    for (double newton = 0; newton <= top_ && (!limitShown || newton < limit_ - 0.5 * step); newton += step) {
        const double y = at(0, newton).y();
        painter.setPen(QPen(theme().plotGrid, 1));
        painter.drawLine(QPointF(a.left(), y), QPointF(a.right(), y));
        painter.setPen(theme().textDimmed);
        const QString label = numberText(newton, step < 0.5 ? 2
                                                 : step < 1 ? 1
                                                            : 0) +
                              (newton == 0 ? tr(" N") : QString());
        painter.drawText(QRectF(0, y - 8, a.left() - 6, 16), Qt::AlignRight | Qt::AlignVCenter, label);
    }
}

void ForcePlot::paintLimit(QPainter& painter) const {
    if (limit_ > top_) return; // the legend says where it is
    const QRectF a = area();
    const double y = at(0, limit_).y();
    painter.setPen(QPen(theme().fault, 1.25, Qt::DashLine));
    painter.drawLine(QPointF(a.left(), y), QPointF(a.right(), y));
    painter.setPen(theme().fault);
    painter.drawText(QRectF(0, y - 8, a.left() - 6, 16), Qt::AlignRight | Qt::AlignVCenter,
                     numberText(limit_, 1));
}

void ForcePlot::paintForce(QPainter& painter) const {
    QPolygonF line;
    for (const Sample& s : samples_)
        line << at(s.t, s.force);
    if (line.size() < 2) return;
    QPolygonF filled = line;
    filled << QPointF(line.back().x(), area().bottom()) << QPointF(line.front().x(), area().bottom());
    QColor shade = theme().proxy;
    shade.setAlphaF(0.12f);
    painter.setPen(Qt::NoPen);
    painter.setBrush(shade);
    painter.drawPolygon(filled);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme().proxy, 1.75));
    painter.drawPolyline(line);
}

void ForcePlot::paintTangential(QPainter& painter) const {
    for (std::size_t i = 1; i < samples_.size(); ++i) {
        const Sample &from = samples_[i - 1], &to = samples_[i];
        if (!from.touching && !to.touching) continue;
        // Slipping is thicker as well: colour is never the only sign.
        painter.setPen(to.slipping ? QPen(theme().slip, 2.5, Qt::SolidLine) : QPen(theme().stick, 1.5));
        painter.drawLine(at(from.t, from.tangential), at(to.t, to.tangential));
    }
}

void ForcePlot::paintLegend(QPainter& painter) const {
    const std::pair<QString, QColor> entries[] = {
        {tr("force"), theme().proxy},
        {tr("along the surface: sticking"), theme().stick},
        {tr("slipping"), theme().slip},
        {limit_ > top_ ? tr("device limit %1 N, above \u2191").arg(numberText(limit_, 1))
                       : tr("device limit"),
         theme().fault},
    };
    double x = area().left();
    for (const auto& [word, colour] : entries) {
        painter.setPen(QPen(colour, 2.5));
        painter.drawLine(QPointF(x, 12), QPointF(x + 14, 12));
        painter.setPen(theme().textDimmed);
        painter.drawText(QPointF(x + 20, 16), word);
        x += 20 + painter.fontMetrics().horizontalAdvance(word) + 2 * kRhythm;
    }
    painter.setPen(paused_ ? theme().accent : theme().textDimmed);
    painter.drawText(QRectF(0, 4, area().right(), 16), Qt::AlignRight | Qt::AlignVCenter,
                     paused_ ? tr("paused") : tr("last %1 s").arg(kSpan, 0, 'f', 0));
}

} // namespace tactum
