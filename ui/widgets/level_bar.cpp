#include "ui/widgets/level_bar.h"

#include <algorithm>

#include <QPainter>

#include "ui/base/style.h"

namespace tactum {

LevelBar::LevelBar(QWidget* parent) : QWidget(parent) {
    setFixedHeight(sizeHint().height());
}

void LevelBar::setLevel(double value, double mark, double top, const QString& word) {
    value_ = value;
    mark_ = mark;
    top_ = top;
    word_ = word;
    update();
}

void LevelBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF bar(1, 4, width() - 2, 6);
    const auto x = [&](double v) { return bar.left() + bar.width() * std::clamp(v / top_, 0.0, 1.0); };
    const auto fill = [&](double from, double to, const QColor& colour) {
        painter.setBrush(colour);
        painter.drawRoundedRect(QRectF(x(from), bar.top(), x(to) - x(from), bar.height()), 3, 3);
    };
    painter.setPen(Qt::NoPen);
    fill(0, top_, theme().border);
    if (value_ > mark_) fill(0, value_, theme().fault);
    fill(0, std::min(value_, mark_), theme().accent);
    painter.setPen(QPen(theme().fault, 1.5));
    painter.drawLine(QPointF(x(mark_), bar.top() - 3), QPointF(x(mark_), bar.bottom() + 3));
    painter.setFont(figureFont(-1));
    painter.setPen(theme().textDimmed);
    const double wide = painter.fontMetrics().horizontalAdvance(word_) + 2;
    const double left = std::clamp(x(mark_) - 0.5 * wide, 0.0, std::max(0.0, width() - wide));
    painter.drawText(QRectF(left, bar.bottom() + 3, wide, 14), Qt::AlignCenter, word_);
}

} // namespace tactum
