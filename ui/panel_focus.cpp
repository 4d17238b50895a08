#include "ui/panel_focus.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>

namespace tactum {

namespace {

/// The first part of a panel that takes the keys.
QWidget* firstWithKeys(QWidget& panel) {
    if (panel.focusPolicy() & Qt::TabFocus) return &panel;
    for (auto* part : panel.findChildren<QWidget*>())
        if (part->isVisibleTo(&panel) && part->isEnabled() && (part->focusPolicy() & Qt::TabFocus) &&
            !part->focusProxy())
            return part;
    return &panel;
}

} // namespace

void focusNextPanel(QWidget& centre, const QList<QDockWidget*>& docks, bool forward) {
    QList<QDockWidget*> open = docks;
    // What lies behind a tab is hidden, but its action knows better.
    open.removeIf([](const QDockWidget* dock) { return !dock->toggleViewAction()->isChecked(); });
    QList<QWidget*> ring{&centre};
    for (QDockWidget* dock : open)
        ring << dock->widget();
    const QWidget* now = QApplication::focusWidget();
    qsizetype at = 0;
    for (qsizetype i = 0; i < ring.size(); ++i)
        if (now && (ring[i] == now || ring[i]->isAncestorOf(now))) at = i;
    const qsizetype next = (at + (forward ? 1 : ring.size() - 1)) % ring.size();
    if (next > 0) open[next - 1]->raise();
    firstWithKeys(*ring[next])->setFocus(Qt::TabFocusReason);
}

} // namespace tactum
