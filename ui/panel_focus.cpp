#include "ui/panel_focus.h"

#include <algorithm>

#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>

namespace tactum {

namespace {

/// The first part of a panel that takes the keys: in the order of Tab, which is that of making.
QWidget* firstWithKeys(QWidget& panel) {
    if (panel.focusPolicy() & Qt::TabFocus) return &panel;
    for (auto* part : panel.findChildren<QWidget*>())
        if (part->isVisibleTo(&panel) && part->isEnabled() && (part->focusPolicy() & Qt::TabFocus) &&
            !part->focusProxy())
            return part;
    return &panel;
}

/// From left to right, and from top to bottom.
QList<QDockWidget*> openDocks(const QMainWindow& window) {
    QList<QDockWidget*> docks = window.findChildren<QDockWidget*>();
    docks.removeIf([](const QDockWidget* dock) { return dock->isHidden() || !dock->widget(); });
    std::ranges::stable_sort(docks, [](const QDockWidget* a, const QDockWidget* b) {
        return std::pair(a->x(), a->y()) < std::pair(b->x(), b->y());
    });
    return docks;
}

} // namespace

void focusNextPanel(QMainWindow& window, QWidget& centre, bool forward) {
    const QList<QDockWidget*> docks = openDocks(window);
    QList<QWidget*> ring{&centre};
    for (QDockWidget* dock : docks)
        ring << dock->widget();
    const QWidget* now = QApplication::focusWidget();
    qsizetype at = 0;
    for (qsizetype i = 0; i < ring.size(); ++i)
        if (now && (ring[i] == now || ring[i]->isAncestorOf(now))) at = i;
    const qsizetype next = (at + (forward ? 1 : ring.size() - 1)) % ring.size();
    if (next > 0) docks[next - 1]->raise();
    firstWithKeys(*ring[next])->setFocus(Qt::TabFocusReason);
}

} // namespace tactum
