// What the view shows of how things feel: its commands, remembered.
#pragma once

#include <QObject>

#include "ui/controllers/workbench.h"

namespace tactum {

/// Thread: ui.
class FeltController : public QObject {
    Q_OBJECT
public:
    explicit FeltController(const Workbench& bench);

    /// As the commands say; after what has shown less for a while.
    void show();

private:
    Workbench bench_;
};

} // namespace tactum
