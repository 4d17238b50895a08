// Scenes to try a device with, felt in the document's place.
#pragma once

#include <optional>

#include <QObject>

#include "ui/controllers/workbench.h"
#include "ui/engine/device_trial.h"

namespace tactum {

class Arming;
class DeviceTrialPage;
class HandLink;
class Stage;

/// Thread: ui.
class TrialController : public QObject {
    Q_OBJECT
public:
    TrialController(const Workbench& bench, Arming& arming, Stage& stage, HandLink& hand,
                    DeviceTrialPage& page);

    bool running() const { return trial_.has_value(); }
    /// Safe to call when nothing is tried. Forces off: the finger may be inside of the person's model.
    void end();

signals:
    /// By a command: the page should be seen.
    void asked();

private:
    void begin(Trial trial);
    void show();

    Workbench bench_;
    Arming& arming_;
    Stage& stage_;
    HandLink& hand_;
    DeviceTrialPage& page_;
    std::optional<Trial> trial_; ///< that is felt
};

} // namespace tactum
