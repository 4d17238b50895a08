// The self-test of the device that the window has: it is lent to the test, and comes back.
#pragma once

#include <memory>

#include <QObject>
#include <QPointer>

#include "core/self_test/self_test.h"
#include "ui/controllers/workbench.h"

namespace tactum {

class DeviceLink;
class SelfTestDialog;

/// Thread: ui.
class SelfTestController : public QObject {
    Q_OBJECT
public:
    SelfTestController(const Workbench& bench, DeviceLink& link);
    /// Of the next test; a test of this program is in a hurry.
    void setPace(const SelfTestPace& pace) { pace_ = pace; }
    /// Once a frame: whether it can be used now.
    void frame();

private:
    QString whyNot();
    void ask();
    void keep(const SelfTestReport& report);

    Workbench bench_;
    DeviceLink& link_;
    QPointer<SelfTestDialog> dialog_;
    SelfTestPace pace_;
    QString whyNot_ = QStringLiteral("-"); ///< that was shown last
};

} // namespace tactum
