#include "ui/widgets/chart.h"

#include <QPainter>

#include "ui/base/chart_axis.h"

namespace tactum {

Chart::Chart(const QString& name, const QString& said, const QMargins& about, QWidget* parent)
    : QWidget(parent), about_(about) {
    setObjectName(name);
    setAccessibleName(said);
}

void Chart::setHint(const QString& hint) {
    hint_ = hint;
    update();
}

void Chart::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(figureFont(-1));
    if (background().alpha() > 0) painter.fillRect(rect(), background());
    any() ? paintChart(painter) : drawChartHint(painter, rect(), hint_);
}

} // namespace tactum
