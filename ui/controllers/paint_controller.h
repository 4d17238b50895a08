// The brush: its commands, and the row above the view.
#pragma once

#include <QList>
#include <QObject>

#include "ui/controllers/workbench.h"

namespace tactum {

struct Brush;
class LayerPanel;
class PaintTool;
class ToolStrip;

/// Thread: ui.
class PaintController : public QObject {
    Q_OBJECT
public:
    /// Fills the strip, which is seen while the tool is on.
    PaintController(const Workbench& bench, PaintTool& tool, ToolStrip& strip, LayerPanel& layers);

private:
    void connectChoices();
    void change(const char* id, void (*how)(Brush&));
    void fillStrip(const QList<QAction*>& goals, const QList<QAction*>& modes);

    Workbench bench_;
    PaintTool& tool_;
    ToolStrip& strip_;
};

} // namespace tactum
