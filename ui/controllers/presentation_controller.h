// The view alone on the screen, for others to look at.
#pragma once

#include <QObject>

#include "ui/controllers/workbench.h"

namespace tactum {

class Presentation;

/// Thread: ui.
class PresentationController : public QObject {
    Q_OBJECT
public:
    explicit PresentationController(const Workbench& bench);

    /// Whether there was one to leave.
    bool leave();

private:
    void present(bool on);

    Workbench bench_;
    Presentation& presentation_;
    bool panelsWereHidden_ = false; ///< before it
};

} // namespace tactum
