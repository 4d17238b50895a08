// Scenes of runs that died, and the journal of this one.
#include "ui/document/journal.h"
#include "ui/document/recovery.h"
#include "ui/panels/recovery_bar.h"
#include "ui/showing/playback.h"
#include "ui/widgets/notice_bar.h"
#include "ui/window/main_window.h"

namespace tactum {

void MainWindow::connectRecovery() {
    connect(journal_, &Journal::failed, notice_, &NoticeBar::showError);
    connect(recovery_, &Recovery::failed, notice_, &NoticeBar::showError);
    connect(recoveryBar_, &RecoveryBar::recoverAsked, this, [this](std::size_t index) {
        leave(tr("recovering a scene"), [this, index] {
            playback_->end();
            recovery_->recover(index);
        });
    });
    connect(recovery_, &Recovery::progressed, this, [this](double fraction, double secondsLeft) {
        notice_->showProgress(tr("Recovering"), fraction, secondsLeft, false);
    });
    connect(recovery_, &Recovery::recovered, this, [this](const QString& title, bool withHistory) {
        const QString same = withHistory ? tr("%1 is as it was before the program stopped, with its history.")
                                         : tr("%1 is as it was before the program stopped, but without its "
                                              "history, which cannot be read.");
        notice_->showNote(same.arg(title) + u' ' + tr("Save it to keep it; its file has not been touched."));
    });
    recovery_->look();
}

} // namespace tactum
