#include "ui/widgets/force_meter.h"

#include <algorithm>

#include <QPainter>

#include "ui/base/numbers.h"
#include "ui/base/style.h"

namespace tactum {

ForceMeter::ForceMeter(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("force-meter"));
    setFixedSize(sizeHint());
}

void ForceMeter::setForce(double force, double limit) {
    if (force == force_ && limit == limit_ && !accessibleName().isEmpty()) return;
    force_ = force;
    limit_ = limit;
    setAccessibleName(tr("Force %1 N of %2 N").arg(numberText(force_, 2), numberText(limit_, 1)));
    update();
}

void ForceMeter::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF bar(64, 0.5 * height() - 4, 80, 8);
    const bool atLimit = force_ >= 0.999 * limit_;
    painter.setPen(theme().text);
    painter.drawText(QRectF(0, 0, 56, height()), Qt::AlignRight | Qt::AlignVCenter,
                     numberText(force_, 2) + tr(" N"));
    painter.setPen(atLimit ? theme().fault : theme().textDimmed);
    painter.drawText(QRectF(bar.right() + 8, 0, 64, height()), Qt::AlignLeft | Qt::AlignVCenter,
                     atLimit ? tr("at limit") : tr("of %1 N").arg(numberText(limit_, 1)));
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme().border);
    painter.drawRoundedRect(bar, 4, 4);
    QRectF full = bar;
    full.setWidth(bar.width() * std::clamp(force_ / limit_, 0.0, 1.0));
    painter.setBrush(atLimit ? theme().fault : theme().proxy);
    painter.drawRoundedRect(full, 4, 4);
}

} // namespace tactum
