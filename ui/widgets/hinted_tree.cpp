#include "ui/widgets/hinted_tree.h"

#include <utility>

#include <QAction>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>

#include "ui/base/style.h"
#include "ui/widgets/edit_keys.h"

namespace tactum {

void paintHint(QWidget& viewport, const QString& hint) {
    QPainter painter(&viewport);
    painter.setPen(theme().textDimmed);
    const int margin = 12;
    painter.drawText(viewport.rect().adjusted(margin, kRhythm / 2, -margin, -kRhythm),
                     int(Qt::AlignTop | Qt::AlignLeft) | Qt::TextWordWrap, hint);
}

HintedTree::HintedTree(const QString& hint, QWidget* parent) : QTreeWidget(parent), hint_(hint) {
    setHeaderHidden(true);
    setIndentation(2 * kRhythm);
    setUniformRowHeights(true);
    header()->setStretchLastSection(false);
}

void HintedTree::setWrapping() {
    setUniformRowHeights(false);
    setWordWrap(true);
    setTextElideMode(Qt::ElideNone);
    setIconSize({16, 16});
    setColumnCount(1);
    header()->setSectionResizeMode(0, QHeaderView::Stretch);
}

/// A tree leaves the height of wrapped rows to whoever fills it.
void HintedTree::wrapRows() {
    const int width = columnWidth(0) - iconSize().width() - 3 * kRhythm;
    for (int i = 0; i < topLevelItemCount(); ++i) {
        const QRect text =
            fontMetrics().boundingRect(0, 0, width, 10000, Qt::TextWordWrap, topLevelItem(i)->text(0));
        topLevelItem(i)->setSizeHint(0, QSize(width, text.height() + kRhythm));
    }
}

bool HintedTree::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        if (ownActionOf(*this, key) || (keepsEditKeys() && isEditKey(key))) event->accept();
    }
    return QTreeWidget::event(event);
}

void HintedTree::keyPressEvent(QKeyEvent* event) {
    if (QAction* own = ownActionOf(*this, *event)) return own->trigger(); // nothing while it is off
    QTreeWidget::keyPressEvent(event);
}

void HintedTree::resizeEvent(QResizeEvent* event) {
    QTreeWidget::resizeEvent(event);
    if (wordWrap()) wrapRows();
}

void HintedTree::setHint(const QString& hint) {
    if (std::exchange(hint_, hint) != hint) viewport()->update();
}

void HintedTree::paintEvent(QPaintEvent* event) {
    QTreeWidget::paintEvent(event);
    for (int i = 0; i < topLevelItemCount(); ++i)
        if (!topLevelItem(i)->isHidden()) return;
    paintHint(*viewport(), hint_);
}

} // namespace tactum
