#include "ui/controllers/recording_controller.h"

#include <algorithm>

#include <QAction>
#include <QDateTime>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QShortcut>
#include <QStandardPaths>

#include "core/recording/recording_file.h"
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

/// The tools that change something; `measure` is of recordings, too.
constexpr const char* kLiveTools[] = {"touch", "select", "paint", "arrange"};
/// The docks that show recordings, and a library that changes nothing by itself.
constexpr const char* kDocksOfRecordings[] = {"dock-health", "dock-plot", "dock-presets"};

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
    actions.setLive(live);
    for (const char* id : kLiveTools)
        actions[id].setEnabled(live);
    for (auto* dock : bench_.window.findChildren<QDockWidget*>())
        if (std::ranges::count(kDocksOfRecordings, dock->objectName()) == 0) dock->widget()->setEnabled(live);
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
