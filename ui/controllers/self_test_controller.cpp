#include "ui/controllers/self_test_controller.h"

#include <utility>

#include "core/runtime/engine.h"
#include "core/safety/force_gate.h"
#include "ui/base/words.h"
#include "ui/controllers/command_reasons.h"
#include "ui/engine/device_link.h"
#include "ui/panels/self_test_dialog.h"
#include "ui/showing/playback.h"

namespace tactum {

SelfTestController::SelfTestController(const Workbench& bench, DeviceLink& link)
    : QObject(&bench.window), bench_(bench), link_(link) {
    bench.on("self-test", this, [this] { ask(); });
    connect(&link, &DeviceLink::lent, this,
            [this](const std::shared_ptr<std::unique_ptr<HapticDevice>>& device, const QString& failure) {
                if (!dialog_) return link_.takeBack();
                if (device)
                    dialog_->begin(std::move(*device), pace_);
                else
                    dialog_->fail(failure);
            });
    connect(&link, &DeviceLink::figuresKept, this, [this](const QString& sentence, bool kept) {
        if (dialog_)
            dialog_->tellKept(
                kept ? tr("%1 They hold from the next connection on, which comes when you close this.")
                           .arg(sentence)
                     : sentence,
                !kept);
    });
    frame();
}

QString SelfTestController::whyNot() {
    if (bench_.playback.active()) return whyOff({}, true);
    if (const QString why = link_.whyNotLend(); !why.isEmpty()) return why;
    if (link_.hands().anyArmed()) return tr("The forces are on; switch them off first.");
    if (isFault(bench_.engine.servo().inhibit))
        return tr("The device is held after a fault; arm it once more first.");
    return {};
}

void SelfTestController::frame() {
    const QString why = whyNot();
    if (why == whyNot_) return;
    whyNot_ = why;
    bench_.actions.allow("self-test", why);
}

void SelfTestController::ask() {
    if (dialog_ || !whyNot().isEmpty()) return;
    dialog_ = new SelfTestDialog(wordsOf(link_.hands().device(0).name), &bench_.window);
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog_, &SelfTestDialog::started, &link_, &DeviceLink::lend);
    connect(dialog_, &SelfTestDialog::keep, this, &SelfTestController::keep);
    connect(dialog_, &QDialog::finished, &link_, &DeviceLink::takeBack);
    dialog_->open();
}

void SelfTestController::keep(const SelfTestReport& report) {
    link_.keepFigures(asIs(report.device.name), profileOfReport(report, selfTestDate()));
}

} // namespace tactum
