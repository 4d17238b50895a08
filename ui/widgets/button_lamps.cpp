#include "ui/widgets/button_lamps.h"

#include <algorithm>

#include <QPainter>

#include "ui/base/style.h"

namespace tactum {

namespace {
constexpr int kMaxLamps = 8, kSize = 20, kGap = 4;
}

ButtonLamps::ButtonLamps(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("device-buttons"));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void ButtonLamps::setButtons(int count, std::uint32_t held) {
    count = std::clamp(count, 0, kMaxLamps);
    if (count == count_ && held == held_ && !accessibleName().isEmpty()) return;
    if (count != count_) updateGeometry();
    count_ = count;
    held_ = held;
    QStringList names;
    for (int i = 0; i < count_; ++i)
        if (held_ >> i & 1) names << QString::number(i + 1);
    setAccessibleName(names.isEmpty() ? tr("No button is held")
                                      : tr("Held buttons: %1").arg(names.join(QStringLiteral(", "))));
    update();
}

QSize ButtonLamps::sizeHint() const {
    return {std::max(1, count_) * (kSize + kGap) - kGap, kSize};
}

void ButtonLamps::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (int i = 0; i < count_; ++i) {
        const bool held = held_ >> i & 1;
        const QRectF lamp(i * (kSize + kGap) + 0.5, 0.5, kSize - 1, kSize - 1);
        painter.setPen(held ? theme().accent : theme().textDimmed);
        painter.setBrush(held ? theme().accent : theme().field);
        painter.drawRoundedRect(lamp, 4, 4);
        painter.setPen(held ? theme().accentText : theme().textDimmed);
        painter.drawText(lamp, Qt::AlignCenter, QString::number(i + 1));
    }
}

} // namespace tactum
