// The plot of the last seconds as a file.
#pragma once

#include <QObject>

#include "ui/controllers/workbench.h"

namespace tactum {

class ForcePlot;

/// Thread: ui.
class PlotController : public QObject {
    Q_OBJECT
public:
    PlotController(const Workbench& bench, ForcePlot& plot);

private:
    void exportPlot();

    Workbench bench_;
    ForcePlot& plot_;
};

} // namespace tactum
