// What is felt vibrates in a gamepad: the command, which gamepad, and why none does.
#pragma once

#include <optional>

#include <QObject>

#include "ui/base/preferences.h"
#include "ui/controllers/workbench.h"
#include "ui/rumble/pads.h"

class QMenu;

namespace tactum {

class RumbleLink;

/// Whether it is on, and which gamepad is chosen, is remembered. Thread: ui.
class RumbleController : public QObject {
    Q_OBJECT
public:
    RumbleController(const Workbench& bench, RumbleLink& link);

private:
    void setOn(bool on);
    void follow(Preferred id);
    void choose(const Pad& pad);
    void fill(QMenu& menu);
    void tellPads();

    Workbench bench_;
    RumbleLink& rumble_;
    bool quiet_ = false;      ///< nobody asked: what is found first is not said
    std::optional<Pad> used_; ///< as was said last
};

} // namespace tactum
