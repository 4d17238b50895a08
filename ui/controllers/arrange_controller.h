// Moving, turning and scaling objects: commands, and the row above the view.
#pragma once

#include <QObject>

#include "ui/controllers/workbench.h"

namespace tactum {

class ArrangeTool;
class ToolStrip;

/// Thread: ui.
class ArrangeController : public QObject {
    Q_OBJECT
public:
    ArrangeController(const Workbench& bench, ArrangeTool& arranging, ToolStrip& strip);

private:
    void connectChoices();
    void connectLines();
    void fill(ToolStrip& strip);

    Workbench bench_;
    ArrangeTool& arranging_;
};

} // namespace tactum
