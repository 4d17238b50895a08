// The panels around the view and where they stand at first.
#pragma once

#include <QMainWindow>

class QDockWidget;
class QTabBar;

namespace tactum {

/// Pixels, as wide as the panels beside the view begin.
inline constexpr int kLeftDocks = 216, kRightDocks = 284;

class BodyPanel;
class Document;
class ForcePlot;
class HealthPanel;
class Inspector;
class LayerPanel;
class Outliner;
class Problems;

struct Docks {
    Outliner* outliner = nullptr;
    Inspector* inspector = nullptr;
    Problems* problems = nullptr;
    ForcePlot* plot = nullptr;
    HealthPanel* health = nullptr;
    LayerPanel* layers = nullptr;
    BodyPanel* body = nullptr;
};

/// Adds a dock behind another one, in the same tabs.
void addTabBeside(QMainWindow& window, QDockWidget& beside, const QString& name, const QString& title,
                  QWidget* body);

/// The tabs that name a dock; none where it stands alone.
QTabBar* tabsOf(const QMainWindow& window, const QDockWidget& dock);
QDockWidget* dockOf(const QMainWindow& window, const QTabBar& tabs, int tab);
/// The dock that lies over this one in the same tabs; none where it is in front itself.
QDockWidget* dockInFrontOf(const QMainWindow& window, const QDockWidget& dock);

/// As they are at first: one that comes later takes the room of the others.
void sizeDocks(QMainWindow& window);

/// Adds all docks to a window; it owns them.
Docks addDocks(QMainWindow& window, Document& document);

} // namespace tactum
