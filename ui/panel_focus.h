// F6: from panel to panel without a mouse.
#pragma once

class QMainWindow;
class QWidget;

namespace tactum {

/// Gives the keys to the next panel that is open, or to the one before; `centre` is one of them. A panel that
/// lies behind a tab comes to the front. Thread: ui.
void focusNextPanel(QMainWindow& window, QWidget& centre, bool forward);

} // namespace tactum
