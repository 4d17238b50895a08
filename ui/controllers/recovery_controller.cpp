#include "ui/controllers/recovery_controller.h"

#include "ui/document/recovery.h"
#include "ui/panels/recovery_bar.h"
#include "ui/showing/playback.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

RecoveryController::RecoveryController(const Workbench& bench, Recovery& recovery, RecoveryBar& bar)
    : QObject(&bench.window), bench_(bench), recovery_(recovery) {
    connect(&recovery, &Recovery::failed, &bench.notice, &NoticeBar::showError);
    connect(&bar, &RecoveryBar::recoverAsked, this, [this](std::size_t index) {
        emit replaces(tr("recovering a scene"), [this, index] {
            bench_.playback.end();
            recovery_.recover(index);
        });
    });
    connect(&recovery, &Recovery::progressed, this, [this](double fraction, double secondsLeft) {
        bench_.notice.showProgress(tr("Recovering"), fraction, secondsLeft, false);
    });
    connect(&recovery, &Recovery::recovered, this, &RecoveryController::say);
}

void RecoveryController::say(const QString& title, bool withHistory) {
    const QString same = withHistory ? tr("%1 is as it was before the program stopped, with its history.")
                                     : tr("%1 is as it was before the program stopped, but without its "
                                          "history, which cannot be read.");
    bench_.notice.showNote(same.arg(title) + u' ' + tr("Save it to keep it; its file has not been touched."));
}

} // namespace tactum
