// Forces on and off, of all hands at once: the one way there, and what is said and offered about it.
#pragma once

#include <QObject>
#include <QString>

#include "core/runtime/hands.h"
#include "ui/base/shortcuts.h"

namespace tactum {

class DeviceLink;
class Engine;
class GuardWatch;
class NoticeBar;
class SceneView;

/// Shared by the controllers. Thread: ui.
class Arming : public QObject {
    Q_OBJECT
public:
    Arming(Engine& engine, Actions& actions, SceneView& view, NoticeBar& notice, GuardWatch& guard,
           DeviceLink& link, QObject* parent);

    bool faulty() const;
    /// As a person wants it, by command, key or button; said in the notices.
    void set(bool armed);
    /// Without a word: something else is felt from now on.
    void switchOff();
    /// Likewise.
    void switchOn();
    /// Brings the commands to what the engine does: on while any hand has force.
    void show();
    /// After a fault; `more`: what else is to be told about it.
    void offer(const QString& more = {});
    /// Another device is in the engine, without force: nothing is left of the one before.
    void adoptDevice();

private:
    Hands hands_;
    Actions& actions_;
    SceneView& view_;
    NoticeBar& notice_;
    GuardWatch& guard_;
    DeviceLink& link_;
};

} // namespace tactum
