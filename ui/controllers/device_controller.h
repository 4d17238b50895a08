// Devices in the window: what happens when one comes or goes, its buttons, its workspace.
#pragma once

#include <vector>

#include <QObject>

#include "ui/controllers/workbench.h"
#include "ui/engine/device_settings.h"

namespace tactum {

class Arming;
class DeviceLink;
class DevicePanel;
class Folds;
class HandLink;
class TouchHint;
class UsbPermission;

/// Thread: ui.
class DeviceController : public QObject {
    Q_OBJECT
public:
    DeviceController(const Workbench& bench, Arming& arming, DeviceLink& link, HandLink& hand,
                     TouchHint& hint, Folds& folds, DevicePanel& panel);

    /// Once a frame.
    void frame();
    /// Brings the dock to the front, at one of its pages (DevicePanel::Page).
    void showPage(int page);
    /// Brings the commands to what can be done now.
    void showCommands();
    /// Once more that a device went away; `more`: what else is to be told about it.
    void sayAway(const QString& more = {});
    /// Tells the view whose the touch is that it gets next, and where the other hands are.
    void showHands();

signals:
    /// Other devices are in the engine, without force, with the settings that are remembered of them.
    void adopted();
    /// The engine speaks of another hand.
    void handChosen();

private:
    void connectCommands();
    void connectLink();
    void connectHands();
    bool lead();
    void connectConnecting();
    void connectLive();
    void connectWorkspace();
    void choose();
    void adopt();
    void addHand();
    void chooseHand(std::size_t hand);
    void chooseNextHand();
    // Of the chosen hand.
    const DeviceSettings& settings() const;
    void setSettings(const DeviceSettings& settings);
    void apply(std::size_t hand, const DeviceSettings& settings);
    void applyReach();
    void showSettings();
    void setWorkspace(const Workspace& workspace);
    void centreWorkspace(bool fit);
    void offerReady(const QString& name, bool back);
    void sayRequest();

    Workbench bench_;
    Arming& arming_;
    DeviceLink& link_;
    HandLink& hand_;
    TouchHint& hint_;
    Folds& folds_;
    DevicePanel& panel_;
    UsbPermission* permission_;
    std::vector<DeviceSettings> settings_; ///< of the device of each hand
    QString away_;                         ///< what was said when a device went away last
};

} // namespace tactum
