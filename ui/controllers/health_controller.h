// Guard and health in the window: what a fault does, and who may render above the stiffness ceiling.
#pragma once

#include <QObject>

#include "ui/controllers/workbench.h"

namespace tactum {

class Arming;
class GuardWatch;
class HealthPanel;
class Inspector;
class StatusStrip;

/// Thread: ui.
class HealthController : public QObject {
    Q_OBJECT
public:
    HealthController(const Workbench& bench, Arming& arming, GuardWatch& guard, HealthPanel& panel,
                     Inspector& inspector, StatusStrip& status);

    /// Once a frame.
    void frame();
    /// Of what is played from now on, or of the loops again.
    void showOf(bool recording);
    /// Another device is in the engine.
    void adoptDevice();

private:
    void display();
    void displayRecorded();
    void restoreDeadMan();
    void setDeadMan(bool on);
    void askToOverride(bool on);

    Workbench bench_;
    Arming& arming_;
    GuardWatch& guard_;
    HealthPanel& panel_;
    Inspector& inspector_;
    StatusStrip& status_;
    int frames_ = 0;            ///< since the health was last displayed
    bool riskAccepted_ = false; ///< of stiffness above the ceiling, with this device, until the program ends
};

} // namespace tactum
