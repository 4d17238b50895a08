// How the view is divided, by command and by the mouse, and back the next day.
#pragma once

#include <QObject>

#include "ui/controllers/workbench.h"

class QActionGroup;

namespace tactum {

/// Choosing what is on already goes back to one view. Thread: ui.
class SplitController : public QObject {
    Q_OBJECT
public:
    explicit SplitController(const Workbench& bench);

private:
    void show();
    void followProjection();

    Workbench bench_;
    QActionGroup* ways_;
};

} // namespace tactum
