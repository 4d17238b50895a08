#include "ui/controllers/panel_focus.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>

#include "ui/controllers/folds.h"

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

void focusNextPanel(const QList<QWidget*>& centre, const QList<QDockWidget*>& docks, Folds& folds,
                    bool forward) {
    QList<QDockWidget*> open = docks;
    // What lies behind a tab is hidden, but its action knows better.
    open.removeIf([](const QDockWidget* dock) { return !dock->toggleViewAction()->isChecked(); });
    QList<QWidget*> ring = centre;
    ring.removeIf([](const QWidget* part) { return !part->isVisible(); });
    const qsizetype central = ring.size();
    for (QDockWidget* dock : open)
        ring << dock->widget();
    const QWidget* now = QApplication::focusWidget();
    qsizetype at = 0;
    for (qsizetype i = 0; i < ring.size(); ++i)
        if (now && (ring[i] == now || ring[i]->isAncestorOf(now))) at = i;
    const qsizetype next = (at + (forward ? 1 : ring.size() - 1)) % ring.size();
    if (next >= central) folds.bringForward(*open[next - central]);
    firstWithKeys(*ring[next])->setFocus(Qt::TabFocusReason);
}

} // namespace tactum
