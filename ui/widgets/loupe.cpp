#include "ui/widgets/loupe.h"

#include <cmath>
#include <utility>

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>

#include "ui/base/numbers.h"
#include "ui/base/style.h"
#include "ui/base/theme.h"

namespace tactum {

namespace {
constexpr double kRound = 6, kLinePad = 6; // logical pixels
constexpr double kNotch = 120;             // of QWheelEvent
} // namespace

Loupe::Loupe(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("loupe"));
    setAccessibleName(tr("Loupe"));
    setToolTip(tr("The wheel makes it larger and smaller"));
    setAttribute(Qt::WA_NoMousePropagation);
    setFocusPolicy(Qt::NoFocus);
    hide();
}

void Loupe::setPicture(const QImage& picture, const QString& pane) {
    picture_ = picture;
    if (std::exchange(pane_, pane) != pane) showWords();
    update();
}

void Loupe::setTimes(double times) {
    times_ = times;
    showWords();
    update();
}

void Loupe::showWords() {
    const QString times =
        tr("%1 times as large").arg(numberText(times_, times_ == std::round(times_) ? 0 : 1));
    setAccessibleDescription(pane_.isEmpty() ? times : QStringLiteral("%1: %2").arg(pane_, times));
}

void Loupe::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    QPainterPath inside;
    inside.addRoundedRect(frame, kRound, kRound);
    painter.setClipPath(inside);
    painter.drawImage(rect(), picture_);
    const double line = painter.fontMetrics().height() + kLinePad;
    const double width = painter.fontMetrics().horizontalAdvance(accessibleDescription()) + 2 * kLinePad;
    const QRectF label(0, height() - line, width, line);
    painter.fillRect(label, theme().label);
    painter.setPen(theme().labelText);
    painter.drawText(label, Qt::AlignCenter, accessibleDescription());
    painter.setClipping(false);
    painter.setPen(QPen(theme().textDimmed, 1));
    painter.drawPath(inside);
}

void Loupe::wheelEvent(QWheelEvent* event) {
    event->accept();
    emit turned(event->angleDelta().y() / kNotch);
}

void Loupe::leaveEvent(QEvent*) {
    emit left();
}

void Loupe::mousePressEvent(QMouseEvent* event) {
    event->accept();
}

} // namespace tactum
