// Forces on and off, of all hands at once: the one way there, and what is said and offered about it.
#pragma once

#include <optional>

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
    /// As a person wants it, by command, key or button; said in the notices. A device whose driver cannot get
    /// over its trouble by itself is opened anew instead of armed.
    void set(bool armed);
    /// What arming does after a fault, in a button's words.
    QString again() const;
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
    std::optional<std::size_t> brokenHand() const;

    Hands hands_;
    Actions& actions_;
    SceneView& view_;
    NoticeBar& notice_;
    GuardWatch& guard_;
    DeviceLink& link_;
};

} // namespace tactum
