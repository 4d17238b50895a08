// Scenes of runs that died, offered and brought back.
#pragma once

#include <functional>

#include <QObject>

#include "ui/controllers/workbench.h"

namespace tactum {

class Recovery;
class RecoveryBar;

/// Thread: ui.
class RecoveryController : public QObject {
    Q_OBJECT
public:
    RecoveryController(const Workbench& bench, Recovery& recovery, RecoveryBar& bar);

signals:
    /// Something else than the document that is open is wanted: `goOn` where nothing would be lost by it.
    void replaces(const QString& intent, const std::function<void()>& goOn);

private:
    void say(const QString& title, bool withHistory);

    Workbench bench_;
    Recovery& recovery_;
};

} // namespace tactum
