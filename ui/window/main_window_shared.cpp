// A scene and a device of a haptic server in the window.
#include "ui/window/main_window.h"

#include <QAction>
#include <QApplication>
#include <QProcess>
#include <QStackedWidget>

#include "ui/base/words.h"
#include "ui/controllers/arming.h"
#include "ui/controllers/stage.h"
#include "ui/engine/shared_link.h"
#include "ui/panels/connection_bar.h"
#include "ui/panels/device_connect.h"
#include "ui/panels/device_panel.h"
#include "ui/panels/start_page.h"
#include "ui/tools/hand_link.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"
#include "ui/window/connect_dialog.h"

namespace tactum {

/// Another window: this one has a device of its own, and a scene that nobody should lose by a word.
void MainWindow::connectToServer() {
    const ServerAddress address = askForServer(this);
    if (address.place.isEmpty()) return;
    QStringList words{QStringLiteral("--connect"), address.place};
    if (!address.credentials.isEmpty()) words << QStringLiteral("--credentials") << address.credentials;
    if (!QProcess::startDetached(QApplication::applicationFilePath(), words))
        notice_->showError(
            tr("The window for %1 cannot be started: install the program again.").arg(address.place));
}

void MainWindow::setShared(SharedScene& shared) {
    shared_ = new SharedLink(document_, engine_, shared, this);
    stage_->setApart([this] { return !shared_->state().connected; });
    connect(shared_, &SharedLink::changed, this, [this] {
        const SharedState& state = shared_->state();
        connection_->display(state);
        devicePanel_->connecting().showServer(state.place,
                                              state.connected ? wordsOf(engine_.device().name) : QString());
        stage_->showCentre();
        arming_->show();
    });
    connect(connection_, &ConnectionBar::penWanted, shared_, [this] { shared_->askForPen(); });
    connect(shared_, &SharedLink::refused, this, [this](const QString& sentence) {
        notice_->showError(sentence);
        arming_->show();
    });
    connect(shared_, &SharedLink::told, notice_, &NoticeBar::showNote);
    connect(shared_, &SharedLink::foundAnother, this, [this](const QString& sentence) {
        notice_->offer(sentence, QStringLiteral("note"), tr("Send mine"),
                       [this] { document_.history().undo(); });
    });
    connect(shared_, &SharedLink::penAskedBy, this, [this](const QString& name) {
        notice_->offer(tr("%1 asks to edit.").arg(name), QStringLiteral("note"), tr("Let them"),
                       [this, name] { shared_->givePen(name); });
    });
    connect(shared_, &SharedLink::penNotAskedAnyMore, notice_, [this] { notice_->withdraw(tr("Let them")); });
}

} // namespace tactum
