// Selecting: what a click, a drawing over the view and a command take, and the row above the view.
#pragma once

#include <optional>

#include <QList>
#include <QObject>

#include "ui/controllers/workbench.h"
#include "ui/view/scene_picker.h"

namespace tactum {

class RegionSelect;
class SelectionSetsMenu;
class SelectTool;
class ToolStrip;

/// Thread: ui.
class SelectController : public QObject {
    Q_OBJECT
public:
    /// Fills the row, with a button for the sets in it.
    SelectController(const Workbench& bench, ToolStrip& strip, SelectionSetsMenu& sets);

    /// A click of the tool.
    void take(const std::optional<PickHit>& hit, Qt::KeyboardModifiers modifiers);
    /// Shows in the view and the commands what is selected.
    void showSelection();

private:
    void connectReaches();
    void connectCommands();
    void connectRegions();
    void connectBrush();
    void fillStrip(ToolStrip& strip, SelectionSetsMenu& sets);
    void addAngle(ToolStrip& strip, const QList<QAction*>& reaches);

    Workbench bench_;
    SelectTool* tool_;
    RegionSelect* regions_;
};

} // namespace tactum
