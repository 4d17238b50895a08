// Devices in the window: what happens when one comes or goes, its buttons, its workspace.
#pragma once

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
    /// A device went away; `more`: what else is to be told about it.
    void sayAway(const QString& name, const QString& more = {});

signals:
    /// Another device is in the engine, without force, with the settings that are remembered of it.
    void adopted();

private:
    void connectCommands();
    void connectLink();
    void connectConnecting();
    void connectLive();
    void connectWorkspace();
    void choose();
    void adopt();
    void setSettings(const DeviceSettings& settings);
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
    DeviceSettings settings_; ///< of the device in the engine
};

} // namespace tactum
