#include "ui/panels/history_list.h"

#include <QEvent>
#include <QStyledItemDelegate>
#include <QUndoStack>

#include "ui/base/style.h"
#include "ui/widgets/edit_keys.h"

namespace tactum {

namespace {

/// Row 0 is the scene as it was opened, row i the step i.
class StepDelegate : public QStyledItemDelegate {
public:
    StepDelegate(const QUndoStack& steps, QObject* parent) : QStyledItemDelegate(parent), steps_(steps) {}

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        if (index.row() <= steps_.index()) return;
        option->palette.setColor(QPalette::Text, theme().textDimmed);
        option->font.setItalic(true);
    }

private:
    const QUndoStack& steps_;
};

} // namespace

HistoryList::HistoryList(QUndoStack& steps, QWidget* parent) : QUndoView(&steps, parent) {
    setObjectName(QStringLiteral("history"));
    setEmptyLabel(tr("As opened"));
    setCleanIcon(icon(QStringLiteral("save")));
    setToolTip(tr("Click a step to go back or forth to it; the disk marks what is saved"));
    setAccessibleName(tr("History"));
    setItemDelegate(new StepDelegate(steps, this));
    connect(&steps, &QUndoStack::indexChanged, viewport(), qOverload<>(&QWidget::update));
}

bool HistoryList::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && isEditKey(*static_cast<QKeyEvent*>(event)))
        event->accept();
    return QUndoView::event(event);
}

void HistoryList::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) setCleanIcon(icon(QStringLiteral("save")));
    QUndoView::changeEvent(event);
}

} // namespace tactum
