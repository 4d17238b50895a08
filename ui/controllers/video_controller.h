// A video of the view: its size, whether the plot is beside it, where it goes.
#pragma once

#include <QObject>

#include "ui/controllers/workbench.h"

namespace tactum {

class ForcePlot;
class VideoRecorder;

/// Thread: ui.
class VideoController : public QObject {
    Q_OBJECT
public:
    VideoController(const Workbench& bench, ForcePlot& plot);

private:
    void recordVideo(bool on);

    Workbench bench_;
    VideoRecorder& video_;
};

} // namespace tactum
