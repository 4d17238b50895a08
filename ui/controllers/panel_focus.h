// F6: from panel to panel without a mouse.
#pragma once

#include <QList>

class QDockWidget;
class QWidget;

namespace tactum {

class Folds;

/// Gives the keys to the next panel of these that is open, or to the one before; what is visible of `centre`
/// comes before them. A panel that lies behind a tab comes to the front, and what is folded
/// unfolds. Thread: ui.
void focusNextPanel(const QList<QWidget*>& centre, const QList<QDockWidget*>& docks, Folds& folds,
                    bool forward);

} // namespace tactum
