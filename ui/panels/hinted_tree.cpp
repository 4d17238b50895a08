#include "ui/panels/hinted_tree.h"

#include <QHeaderView>
#include <QPainter>

#include "ui/style.h"

namespace tactum {

HintedTree::HintedTree(const QString& hint, QWidget* parent) : QTreeWidget(parent), hint_(hint) {
    setHeaderHidden(true);
    setIndentation(2 * kRhythm);
    setUniformRowHeights(true);
    header()->setStretchLastSection(false);
}

void HintedTree::paintEvent(QPaintEvent* event) {
    QTreeWidget::paintEvent(event);
    if (topLevelItemCount() > 0) return;
    QPainter painter(viewport());
    painter.setPen(theme().textDimmed);
    const int margin = 12;
    painter.drawText(viewport()->rect().adjusted(margin, kRhythm / 2, -margin, -kRhythm),
                     int(Qt::AlignTop | Qt::AlignLeft) | Qt::TextWordWrap, hint_);
}

} // namespace tactum
