// Recordings in the window: saving them, and showing one instead of what is touched now.
#include "ui/window/main_window.h"

#include <QAction>
#include <QDateTime>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QShortcut>
#include <QStackedWidget>
#include <QStandardPaths>

#include "core/recording/recording_file.h"
#include "ui/base/ask_where.h"
#include "ui/base/words.h"
#include "ui/controllers/compare_controller.h"
#include "ui/engine/device_link.h"
#include "ui/engine/guard_watch.h"
#include "ui/panels/status_strip.h"
#include "ui/showing/playback.h"
#include "ui/showing/playback_bar.h"
#include "ui/showing/played_touch.h"
#include "ui/showing/recording_saver.h"
#include "ui/sound/sound_link.h"
#include "ui/tools/arrange_tool.h"
#include "ui/tools/hand_link.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/force_plot.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

namespace {

constexpr double kKeyStep = 0.01; // s

/// What would change the document, the hand or the forces.
constexpr const char* kLiveActions[] = {
    "touch",          "select",         "select-touched", "hide",        "show-all",       "remove",
    "armed",          "stop",           "restart-proxy",  "undo",        "redo",           "record-stroke",
    "take-stroke",    "mark-a",         "swap-ab",        "compare-now", "trial-spring",   "trial-wall",
    "trial-friction", "workspace-axes", "arrange",        "duplicate",   "drop",           "rename",
    "object-up",      "object-down",    "set-keep",       "align-x-low", "align-x-middle", "align-x-high",
    "align-y-low",    "align-y-middle", "align-y-high",   "align-z-low", "align-z-middle", "align-z-high",
    "distribute-x",   "distribute-y",   "distribute-z"};

QString ending() {
    return u'.' + asIs(kRecordingEnding);
}

QString suggestedFile() {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QDir(folder).filePath(
        QDateTime::currentDateTime().toString(QStringLiteral("'touch' yyyy-MM-dd HH-mm")) + ending());
}

} // namespace

void MainWindow::connectRecordings() {
    connect(&actions_["save-recording"], &QAction::triggered, this, &MainWindow::saveRecording);
    connect(saver_, &RecordingSaver::failed, notice_, &NoticeBar::showError);
    connect(saver_, &RecordingSaver::saved, this, [this](const QString& file, bool afterFault) {
        if (afterFault && link_->lost() && !playback_->active())
            return sayAway(link_->lostName(), tr("What led to it was saved: %1.").arg(file));
        if (guard_->fault() && !playback_->active())
            return offerToArm(tr("What led to it was saved: %1.").arg(file));
        notice_->showNote(
            afterFault ? tr("There was a fault. What led to it was saved: open %1 to see it again.").arg(file)
                       : tr("The last minute was saved to %1.").arg(file));
    });
    connect(link_, &DeviceLink::letsGo, saver_, &RecordingSaver::flush);
    connect(playback_, &Playback::begun, this, &MainWindow::beginPlayback);
    connect(playback_, &Playback::begun, this, [this] {
        if (plots_ == Plots::Empty) plots_ = Plots::Due;
    });
    connect(playback_, &Playback::ended, this, &MainWindow::endPlayback);
    connect(playback_, &Playback::failed, notice_, &NoticeBar::showError);
    connect(playback_, &Playback::progressed, this, [this](double fraction, double secondsLeft) {
        if (playback_->opening())
            notice_->showProgress(tr("Opening the recording"), fraction, secondsLeft, false);
    });
    const auto onKey = [this](Qt::Key key, auto act) {
        auto* shortcut = new QShortcut(key, view_, nullptr, nullptr, Qt::WidgetShortcut);
        shortcut->setEnabled(false); // live, the view has these keys
        connect(shortcut, &QShortcut::activated, this, act);
        connect(playback_, &Playback::begun, shortcut, [shortcut] { shortcut->setEnabled(true); });
        connect(playback_, &Playback::ended, shortcut, [shortcut] { shortcut->setEnabled(false); });
    };
    onKey(Qt::Key_Space, [this] { playback_->setPlaying(!playback_->playing()); });
    onKey(Qt::Key_Left, [this] { playback_->seek(playback_->time() - kKeyStep, true); });
    onKey(Qt::Key_Right, [this] { playback_->seek(playback_->time() + kKeyStep, true); });
}

void MainWindow::saveRecording() {
    // The minute before the command, however long the person looks for a place.
    const RecordingSaver::Taken recording = saver_->take(tr("Saved on demand"));
    if (!recording) return;
    const QString file = askWhere(this, tr("Save the last minute"),
                                  {{tr("Recordings"), QString::fromUtf8(kRecordingEnding)}}, suggestedFile());
    if (!file.isEmpty()) saver_->save(file, recording);
}

void MainWindow::setLive(bool live) {
    for (const char* id : kLiveActions)
        actions_[id].setEnabled(live);
    if (live) {
        actions_["undo"].setEnabled(document_.history().canUndo());
        actions_["redo"].setEnabled(document_.history().canRedo());
        actions_["stop"].setEnabled(engine_.armed());
        compare_->showCommands();
        showDeviceCommands();
    }
    showStudyCommands();
    for (const char* name : {"dock-outliner", "dock-problems", "dock-inspector", "dock-history",
                             "dock-compare", "dock-device", "dock-place", "dock-study"})
        if (auto* dock = findChild<QDockWidget*>(QString::fromLatin1(name))) dock->widget()->setEnabled(live);
    if (!live) view_->endTouch(); // or the hand would stay where it presses
    hand_->setSuspended(!live);
    const auto on = [&](const char* tool) { return live && actions_[tool].isChecked(); };
    view_->setTool(on("touch")     ? ViewTool::Touch
                   : on("paint")   ? ViewTool::Paint
                   : on("arrange") ? ViewTool::Arrange
                                   : ViewTool::Select);
    arranging_->setActive(on("arrange"));
}

void MainWindow::beginPlayback() {
    endTrial();
    if (guard_->fault()) notice_->hide(); // it offers to arm, and nobody does while a recording is shown
    guard_->setArmed(false);
    actions_["armed"].setChecked(false);
    setLive(false);
    notice_->endProgress();
    view_->setSelection({});
    shownShape_ = 0;
    centre_->setCurrentWidget(view_);
    setWindowTitle(tr("%1 - Tactum").arg(QFileInfo(playback_->file()).fileName()));
    playFrame();
    showHealthOf(true);
    view_->fit();
    view_->setFocus();
}

void MainWindow::endPlayback() {
    setLive(true);
    showHealthOf(false);
    docks_.plot->clear();
    view_->clearTrail();
    view_->setWorld(publisher_.world());
    const QString name = QFileInfo(QString::fromStdU16String(document_.path().u16string())).fileName();
    setWindowTitle(name.isEmpty() ? tr("Tactum") : tr("%1 - Tactum").arg(name));
    view_->setScene(document_.scene());
    view_->setSelection(document_.selected());
    if (!document_.empty()) view_->fit();
    showCentre();
    notice_->showNote(tr("Live again. The forces are off: Device > Forces on."));
}

void MainWindow::playFrame() {
    playback_->frame();
    Player& player = playback_->player();
    const DeviceInfo& device = player.run().device;
    if (const World* world = player.world(); world && world->shapeRevision != shownShape_) {
        shownShape_ = world->shapeRevision;
        view_->setScene(*world->scene);
    }
    if (view_->isVisible()) view_->setHaptics(player.proxy(), player.servo(), device.maxForce, true);
    view_->setWorld(player.sharedWorld());
    if (playback_->takeJump()) {
        docks_.plot->clear();
        view_->clearTrail();
    }
    if (const World* world = player.world()) showTouched(world, *world->scene);
    sound_->play(showPlayed(player, *docks_.plot, *view_, touchedName_));
    for (TracePoint live; engine_.popTrace(live);)
        continue;
    status_->display(player.proxy(), player.servo(), device);
}

} // namespace tactum
