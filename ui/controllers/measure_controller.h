// Measuring in the view: the commands and the row over the view.
#pragma once

#include <QObject>

#include "ui/controllers/workbench.h"

namespace tactum {

class ToolStrip;

/// A measure is shown, never saved; another scene begins without one. Thread: ui.
class MeasureController : public QObject {
    Q_OBJECT
public:
    explicit MeasureController(const Workbench& bench);

private:
    void fillStrip();
    void copy();
    void show();

    Workbench bench_;
    ToolStrip* strip_;
    const char* toolBefore_ = "touch"; ///< to come back to
};

} // namespace tactum
