#include "ui/widgets/scrubber.h"

#include <algorithm>
#include <cmath>

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include "ui/base/numbers.h"
#include "ui/base/style.h"

namespace tactum {

namespace {

constexpr double kHandle = 6;      // radius, pixels
constexpr double kNearMark = 5;    // pixels
constexpr double kFineStep = 0.01; // s
constexpr double kCoarseStep = 1;  // s

QString textOf(const ScrubberMark& mark) {
    return Scrubber::tr("%1 s: %2").arg(numberText(mark.time, 2), mark.text);
}

} // namespace

Scrubber::Scrubber(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("scrubber"));
    setAccessibleName(tr("Time in the recording"));
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void Scrubber::setRecording(double length, std::vector<ScrubberMark> marks) {
    length_ = length;
    marks_ = std::move(marks);
    time_ = 0;
    held_ = false;
    update();
}

void Scrubber::display(double time) {
    if (held_ || time == time_) return;
    time_ = time;
    update();
}

QRectF Scrubber::groove() const {
    return {kHandle, 0.5 * height() - 2, width() - 2 * kHandle, 4};
}

double Scrubber::xOf(double time) const {
    const double part = length_ > 0 ? std::clamp(time / length_, 0.0, 1.0) : 0;
    return groove().left() + part * groove().width();
}

double Scrubber::timeAt(double x) const {
    return std::clamp((x - groove().left()) / std::max(1.0, groove().width()), 0.0, 1.0) * length_;
}

void Scrubber::go(double time, bool resting) {
    time_ = std::clamp(time, 0.0, length_);
    update();
    emit moved(time_, resting);
}

void Scrubber::paintMark(QPainter& painter, const ScrubberMark& mark) const {
    const double x = xOf(mark.time);
    const QRectF line = groove();
    if (!mark.fault) {
        painter.setPen(QPen(theme().textDimmed, 1.25));
        painter.drawLine(QPointF(x, line.bottom() + 3), QPointF(x, line.bottom() + 8));
        return;
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme().fault);
    const QPointF tip(x, line.top() - 1);
    painter.drawPolygon(QPolygonF{{tip, tip + QPointF(-4.5, -8), tip + QPointF(4.5, -8)}});
}

void Scrubber::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF line = groove();
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme().border);
    painter.drawRoundedRect(line, 2, 2);
    painter.setBrush(theme().accent);
    painter.drawRoundedRect(QRectF(line.topLeft(), QPointF(xOf(time_), line.bottom())), 2, 2);
    for (const ScrubberMark& mark : marks_)
        paintMark(painter, mark);
    painter.setPen(QPen(hasFocus() ? theme().accent : theme().panel, 2));
    painter.setBrush(theme().text);
    painter.drawEllipse(QPointF(xOf(time_), line.center().y()), kHandle, kHandle);
}

void Scrubber::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    held_ = true;
    go(timeAt(event->position().x()), false);
}

void Scrubber::mouseMoveEvent(QMouseEvent* event) {
    if (held_) go(timeAt(event->position().x()), false);
}

void Scrubber::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !held_) return;
    held_ = false;
    go(timeAt(event->position().x()), true);
}

void Scrubber::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Left:
        return go(time_ - kFineStep, true);
    case Qt::Key_Right:
        return go(time_ + kFineStep, true);
    case Qt::Key_PageDown:
        return go(time_ - kCoarseStep, true);
    case Qt::Key_PageUp:
        return go(time_ + kCoarseStep, true);
    case Qt::Key_Home:
        return go(0, true);
    case Qt::Key_End:
        return go(length_, true);
    default:
        QWidget::keyPressEvent(event);
    }
}

const ScrubberMark* Scrubber::markNear(double x) const {
    const ScrubberMark* nearest = nullptr;
    for (const ScrubberMark& mark : marks_) {
        const double distance = std::abs(xOf(mark.time) - x);
        if (distance > kNearMark) continue;
        // A fault among ticks is what one looks for.
        if (!nearest || mark.fault || (!nearest->fault && distance < std::abs(xOf(nearest->time) - x)))
            nearest = &mark;
    }
    return nearest;
}

bool Scrubber::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const ScrubberMark* mark = markNear(help->pos().x());
    const QString time = tr("%1 s").arg(numberText(timeAt(help->pos().x()), 2));
    QToolTip::showText(help->globalPos(), mark ? textOf(*mark) : time, this);
    return true;
}

} // namespace tactum
