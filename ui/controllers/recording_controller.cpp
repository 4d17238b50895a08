#include "ui/controllers/recording_controller.h"

#include <QAction>
#include <QDateTime>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QShortcut>
#include <QStandardPaths>

#include "core/recording/recording_file.h"
#include "core/runtime/engine.h"
#include "ui/base/ask_where.h"
#include "ui/base/words.h"
#include "ui/controllers/arming.h"
#include "ui/controllers/stage.h"
#include "ui/document/document.h"
#include "ui/engine/world_publisher.h"
#include "ui/showing/playback.h"
#include "ui/showing/recording_saver.h"
#include "ui/tools/arrange_tool.h"
#include "ui/tools/hand_link.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

namespace {

constexpr double kKeyStep = 0.01; // s

/// What would change the document, the hand or the forces.
constexpr const char* kLiveActions[] = {
    "touch",          "select",         "select-touched", "hide",         "show-all",     "remove",
    "armed",          "stop",           "restart-proxy",  "undo",         "redo",         "record-stroke",
    "take-stroke",    "mark-a",         "swap-ab",        "compare-now",  "trial-spring", "trial-wall",
    "trial-friction", "workspace-axes", "arrange",        "duplicate",    "drop",         "rename",
    "object-up",      "object-down",    "set-keep",       "camera-keep",  "align-x-low",  "align-x-middle",
    "align-x-high",   "align-y-low",    "align-y-middle", "align-y-high", "align-z-low",  "align-z-middle",
    "align-z-high",   "distribute-x",   "distribute-y",   "distribute-z"};

QString ending() {
    return u'.' + asIs(kRecordingEnding);
}

QString suggestedFile() {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QDir(folder).filePath(
        QDateTime::currentDateTime().toString(QStringLiteral("'touch' yyyy-MM-dd HH-mm")) + ending());
}

} // namespace

RecordingController::RecordingController(const Workbench& bench, Arming& arming, Stage& stage, HandLink& hand,
                                         ArrangeTool& arranging, RecordingSaver& saver)
    : QObject(&bench.window), bench_(bench), arming_(arming), stage_(stage), hand_(hand),
      arranging_(arranging), saver_(saver) {
    Playback& playback = bench.playback;
    bench.on("save-recording", this, [this] { save(); });
    connect(&saver, &RecordingSaver::failed, &bench.notice, &NoticeBar::showError);
    connect(&playback, &Playback::begun, this, &RecordingController::begin);
    connect(&playback, &Playback::ended, this, &RecordingController::end);
    connect(&playback, &Playback::failed, &bench.notice, &NoticeBar::showError);
    connect(&playback, &Playback::progressed, this, [this](double fraction, double secondsLeft) {
        if (bench_.playback.opening())
            bench_.notice.showProgress(tr("Opening the recording"), fraction, secondsLeft, false);
    });
    onKey(Qt::Key_Space, [&playback] { playback.setPlaying(!playback.playing()); });
    onKey(Qt::Key_Left, [&playback] { playback.seek(playback.time() - kKeyStep, true); });
    onKey(Qt::Key_Right, [&playback] { playback.seek(playback.time() + kKeyStep, true); });
    onKey(Qt::Key_Up, [&playback] { playback.changeSpeed(1); });
    onKey(Qt::Key_Down, [&playback] { playback.changeSpeed(-1); });
}

void RecordingController::onKey(Qt::Key key, const std::function<void()>& act) {
    auto* shortcut = new QShortcut(key, &bench_.view, nullptr, nullptr, Qt::WidgetShortcut);
    shortcut->setEnabled(false); // live, the view has these keys
    connect(shortcut, &QShortcut::activated, this, act);
    connect(&bench_.playback, &Playback::begun, shortcut, [shortcut] { shortcut->setEnabled(true); });
    connect(&bench_.playback, &Playback::ended, shortcut, [shortcut] { shortcut->setEnabled(false); });
}

void RecordingController::save() {
    // The minute before the command, however long the person looks for a place.
    const RecordingSaver::Taken recording = saver_.take(tr("Saved on demand"));
    if (!recording) return;
    const QString file = askWhere(&bench_.window, tr("Save the last minute"),
                                  {{tr("Recordings"), QString::fromUtf8(kRecordingEnding)}}, suggestedFile());
    if (!file.isEmpty()) saver_.save(file, recording);
}

void RecordingController::setLive(bool live) {
    Actions& actions = bench_.actions;
    for (const char* id : kLiveActions)
        actions[id].setEnabled(live);
    if (live) {
        actions["undo"].setEnabled(bench_.document.history().canUndo());
        actions["redo"].setEnabled(bench_.document.history().canRedo());
        actions["stop"].setEnabled(Hands(bench_.engine).anyArmed());
    }
    for (const char* name : {"dock-outliner", "dock-problems", "dock-inspector", "dock-history",
                             "dock-compare", "dock-device", "dock-place", "dock-study"})
        bench_.dock(name).widget()->setEnabled(live);
    if (!live) bench_.view.endTouch(); // or the hand would stay where it presses
    hand_.setSuspended(!live);
    const auto on = [&](const char* tool) { return live && actions[tool].isChecked(); };
    const bool measures = actions["measure"].isChecked(); // what a recording shows, too
    bench_.view.setTool(measures        ? ViewTool::Measure
                        : on("touch")   ? ViewTool::Touch
                        : on("paint")   ? ViewTool::Paint
                        : on("arrange") ? ViewTool::Arrange
                                        : ViewTool::Select);
    arranging_.setActive(on("arrange"));
    emit liveChanged(live);
}

void RecordingController::begin() {
    if (arming_.faulty())
        bench_.notice.hide(); // it offers to arm, and nobody does while a recording is shown
    arming_.switchOff();
    setLive(false);
    bench_.notice.endProgress();
    bench_.view.setSelection({});
    stage_.showView();
    bench_.window.setWindowModified(false); // a recording is never edited
    bench_.window.setWindowTitle(tr("%1 - Tactum").arg(QFileInfo(bench_.playback.file()).fileName()));
    emit shown();
    bench_.view.fitAll();
    bench_.view.setFocus();
}

void RecordingController::end() {
    setLive(true);
    const Document& document = bench_.document;
    bench_.window.setWindowTitle(document.isOpen() ? tr("%1[*] - Tactum").arg(document.title())
                                                   : tr("Tactum"));
    bench_.window.setWindowModified(document.modified());
    bench_.view.clearTrail();
    bench_.view.setWorld(bench_.publisher.world());
    stage_.showOwn();
    bench_.notice.showNote(tr("Live again. The forces are off: Device > Forces on."));
}

} // namespace tactum
