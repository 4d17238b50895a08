// The command palette of the window, and the way from panel to panel.
#pragma once

#include <vector>

#include <QObject>

#include "ui/controllers/workbench.h"

class QStackedWidget;

namespace tactum {

class CamerasMenu;
class Folds;
class SelectionSetsMenu;
struct PaletteEntry;

/// Thread: ui.
class PaletteController : public QObject {
    Q_OBJECT
public:
    /// Made when all docks are there. The keys go from what is in the centre over `importBar` to the docks.
    PaletteController(const Workbench& bench, Folds& folds, SelectionSetsMenu& sets, CamerasMenu& cameras,
                      const QStackedWidget& centre, QWidget& importBar);

signals:
    void fileChosen(const QString& file);

private:
    void addButton();
    void open();
    QString whyNot(const QAction& action) const;
    void addCameras(std::vector<PaletteEntry>& entries);
    void addPanels(std::vector<PaletteEntry>& entries);
    void addSurfaces(std::vector<PaletteEntry>& entries);

    Workbench bench_;
    Folds& folds_;
    SelectionSetsMenu& sets_;
    CamerasMenu& cameras_;
};

} // namespace tactum
