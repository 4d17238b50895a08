// Bodies that move: their time, as what they meet each other, how the selected one is held.
#pragma once

#include <QObject>

#include "ui/controllers/workbench.h"

namespace tactum {

class BodyPanel;
class Folds;

/// Thread: ui.
class MotionController : public QObject {
    Q_OBJECT
public:
    MotionController(const Workbench& bench, BodyPanel& panel, Folds& folds);

private:
    void connectTime();
    void connectHolds();
    void connectHandles();
    void showMarks();
    void setPace();
    void tellOfTime(const QString& name);
    void showColliders();

    Workbench bench_;
    BodyPanel& panel_;
    Folds& folds_;
};

} // namespace tactum
