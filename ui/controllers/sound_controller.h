// What is touched is heard: the command, and why it cannot be.
#pragma once

#include <QObject>

#include "ui/controllers/workbench.h"

namespace tactum {

class SoundLink;

/// Thread: ui.
class SoundController : public QObject {
    Q_OBJECT
public:
    SoundController(const Workbench& bench, SoundLink& link);

private:
    void setSound(bool on);

    Workbench bench_;
    SoundLink& sound_;
};

} // namespace tactum
