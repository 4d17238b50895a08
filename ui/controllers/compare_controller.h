// Comparing a stroke over two states of the scene: its dock, its commands, its file.
#pragma once

#include <QObject>

#include "ui/controllers/workbench.h"

namespace tactum {

class Comparison;

/// Thread: ui.
class CompareController : public QObject {
    Q_OBJECT
public:
    /// Adds the dock beside that of the health.
    explicit CompareController(const Workbench& bench);

    Comparison& comparison() { return *comparison_; }
    /// Brings the commands to what can be done now.
    void showCommands();

private:
    void addDock();
    void exportBoth();

    Workbench bench_;
    Comparison* comparison_;
};

} // namespace tactum
