// The keys with which the window deletes, renames, doubles and reorders objects, and those of a list itself.
#pragma once

#include <QAction>
#include <QKeyEvent>
#include <QWidget>

namespace tactum {

/// A list of other things that has the keys keeps the window from that: who presses Del on a preset or on a
/// step of the history means no object.
inline bool isEditKey(const QKeyEvent& key) {
    if (key.key() == Qt::Key_Up || key.key() == Qt::Key_Down) return key.modifiers() == Qt::AltModifier;
    return key.modifiers() == Qt::NoModifier ? key.key() == Qt::Key_Delete || key.key() == Qt::Key_F2
                                             : key.keyCombination() == (Qt::CTRL | Qt::Key_D);
}

/// The action of the widget itself (Qt::WidgetShortcut) that has this key; null for none.
inline QAction* ownActionOf(const QWidget& widget, const QKeyEvent& key) {
    for (QAction* action : widget.actions())
        if (action->shortcutContext() == Qt::WidgetShortcut &&
            action->shortcut() == QKeySequence(key.keyCombination()))
            return action;
    return nullptr;
}

} // namespace tactum
