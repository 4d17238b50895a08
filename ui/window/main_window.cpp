#include "ui/window/main_window.h"

#include <filesystem>

#include <QCloseEvent>
#include <QDockWidget>
#include <QFileInfo>
#include <QGridLayout>
#include <QMimeData>
#include <QScreen>
#include <QSettings>
#include <QShortcut>
#include <QStackedWidget>
#include <QStatusBar>
#include <QVBoxLayout>

#include "ui/controllers/compare_controller.h"
#include "ui/controllers/preset_controller.h"
#include "ui/controllers/section_controller.h"
#include "ui/document/journal.h"
#include "ui/document/layer_edits.h"
#include "ui/document/recent_files.h"
#include "ui/document/recovery.h"
#include "ui/engine/device_link.h"
#include "ui/engine/guard_watch.h"
#include "ui/engine/shared_link.h"
#include "ui/engine/touched.h"
#include "ui/engine/usb_permission.h"
#include "ui/panels/connection_bar.h"
#include "ui/panels/import_bar.h"
#include "ui/panels/inspector.h"
#include "ui/panels/recovery_bar.h"
#include "ui/panels/start_page.h"
#include "ui/panels/status_strip.h"
#include "ui/showing/playback.h"
#include "ui/showing/playback_bar.h"
#include "ui/showing/recording_saver.h"
#include "ui/sound/sound_link.h"
#include "ui/study/study_desk.h"
#include "ui/study/study_page.h"
#include "ui/study/study_session.h"
#include "ui/tools/arrange_tool.h"
#include "ui/tools/hand_link.h"
#include "ui/tools/paint_tool.h"
#include "ui/tools/region_select.h"
#include "ui/tools/select_tool.h"
#include "ui/tools/touch_hint.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/force_plot.h"
#include "ui/widgets/notice_bar.h"
#include "ui/widgets/tool_strip.h"
#include "ui/window/folds.h"

namespace tactum {

namespace {

constexpr int kFrame = 16; // ms

QStringList filesIn(const QMimeData& data) {
    QStringList files;
    for (const QUrl& url : data.urls())
        if (url.isLocalFile()) files << url.toLocalFile();
    return files;
}

QString firstFile(const QMimeData& data) {
    return filesIn(data).value(0);
}

} // namespace

MainWindow::MainWindow(Document& document, Engine& engine, std::shared_ptr<HandTarget> hand,
                       const QStringList& samples, QWidget* parent)
    : QMainWindow(parent), document_(document), engine_(engine), publisher_(document, engine),
      view_(new SceneView), selecting_(new SelectTool(document, this)),
      regions_(new RegionSelect(document, *view_, this)), selectStrip_(new ToolStrip),
      arranging_(new ArrangeTool(document, *view_, this)), arrangeStrip_(new ToolStrip),
      painting_(new PaintTool(document, *view_, this)), paintStrip_(new ToolStrip), notice_(new NoticeBar),
      centre_(new QStackedWidget), start_(new StartPage(samples)), playbackBar_(new PlaybackBar),
      connection_(new ConnectionBar), importBar_(new ImportBar), status_(new StatusStrip),
      hint_(new TouchHint(view_)), hand_(new HandLink(*view_, engine, std::move(hand), this)),
      guard_(new GuardWatch(engine, this)), playback_(new Playback(*playbackBar_, this)),
      saver_(new RecordingSaver(engine, document, this)), journal_(new Journal(document, this)),
      recovery_(new Recovery(document, *journal_, this)), recoveryBar_(new RecoveryBar(*recovery_)),
      studyDesk_(new StudyDesk(document, this)), study_(new StudySession(publisher_, engine, this)),
      studyPage_(new StudyPage), sound_(new SoundLink(this)),
      link_(new DeviceLink(engine, this)), bench_{*this,    document_, engine_,  publisher_,
                                                  actions_, *view_,    *notice_, *playback_},
      permission_(new UsbPermission(this)), samples_(samples) {
    view_->setTheme(theme().dark);
    setCentralWidget(makeCentre());
    docks_ = addDocks(*this, document);
    addPlaceDock();
    compare_ = new CompareController(bench_);
    addStudyDock();
    presets_ = new PresetController(bench_);
    addDeviceDock();
    sizeDocks(*this);
    folds_ = new Folds(*this);
    makeToolBar();
    makeMenus();
    statusBar()->setSizeGripEnabled(false);
    statusBar()->addWidget(status_, 1);
    connectFile();
    connectSaving();
    connectEdit();
    connectView();
    new SectionController(bench_);
    connectSelecting();
    connectArranging();
    connectSurfaces();
    connectPainting();
    connectLayers();
    connectFelt();
    connectDevice();
    connectMotion();
    connectHealth();
    connectDocument();
    connectProblems();
    connectRecordings();
    connectImport();
    connectGeometry();
    connectParts();
    connectRecovery();
    connectPalette();
    connectStudy();
    connectDevices();
    connectPreferences();
    connectShowing();
    setAcceptDrops(true);
    restore();
    follow({});
    connect(&frames_, &QTimer::timeout, this, &MainWindow::frame);
    frames_.start(kFrame);
}

MainWindow::~MainWindow() = default;

Comparison& MainWindow::comparison() {
    return compare_->comparison();
}

QWidget* MainWindow::makeCentre() {
    auto* body = new QWidget;
    // Over the view, not above it: what comes by itself, or with a key, must not move the model under the
    // pointer that is about to press on it.
    auto* layers = new QGridLayout(body);
    layers->setContentsMargins(0, 0, 0, 0);
    layers->addWidget(centre_, 0, 0);
    auto* head = new QVBoxLayout;
    head->setObjectName(QStringLiteral("strips")); // Workbench::strips() knows it by that
    head->setSpacing(0);
    head->addWidget(recoveryBar_);
    head->addWidget(notice_);
    for (ToolStrip* strip : {selectStrip_, arrangeStrip_, paintStrip_})
        head->addWidget(strip, 0, Qt::AlignLeft);
    layers->addLayout(head, 0, 0, Qt::AlignTop);
    auto* foot = new QVBoxLayout;
    foot->setSpacing(0);
    foot->addWidget(importBar_, 0, Qt::AlignHCenter);
    foot->addWidget(connection_, 0, Qt::AlignHCenter);
    foot->addWidget(playbackBar_);
    layers->addLayout(foot, 0, 0, Qt::AlignBottom);
    layers->addWidget(studyPage_, 0, 0);
    centre_->addWidget(start_);
    centre_->addWidget(view_);
    start_->setRecent(recentFiles());
    view_->setFocusPolicy(Qt::StrongFocus);
    view_->setAccessibleName(tr("Model and finger"));
    return body;
}

void MainWindow::open(const QString& file) {
    if (isRecording(file)) return playback_->open(file);
    leave(tr("opening %1").arg(QFileInfo(file).fileName()), [this, file] {
        playback_->end();
        const std::filesystem::path path(file.toStdU16String());
        document_.open(path, samples_.contains(QFileInfo(file).canonicalFilePath()), rememberedAxes(path));
    });
}

void MainWindow::showFault(const QString& sentence) {
    notice_->showError(sentence);
}

void MainWindow::follow(const SceneChange& change) {
    using What = SceneChange::What;
    playback_->end(); // whoever edits wants to see it
    endTrial();
    if (change.what == What::Selection) return showSelection();
    if (change.what == What::ProxyRadius) return view_->setProxyRadius(document_.scene().proxyRadius);
    // The World from before knows other objects by the same numbers.
    if (change.what == What::Everything) view_->setWorld(nullptr);
    if (change.touchesShape()) {
        touched_.reset(); // its number may be another surface's now
        view_->setScene(document_.scene());
        view_->setProxyRadius(document_.scene().proxyRadius);
    }
    if (change.what == What::Everything) {
        showCentre(); // or the view would not know yet how large it is
        view_->fit();
        hand_->placeBeside();
    }
    for (const char* id : {"save", "save-as", "export", "save-picture", "update-geometry", "export-report"})
        actions_[id].setEnabled(!document_.empty());
    showCentre();
}

void MainWindow::showOpened() {
    showFile();
    view_->setFocus();
    if (!hand_->idle()) hint_->offer();
}

void MainWindow::setArmed(bool armed) {
    const bool faulty = guard_->fault().has_value();
    if (armed) link_->stop().pressed = false; // held still, it stops again at once
    if (!armed) view_->endTouch();
    guard_->setArmed(armed);
    showArmed(armed);
    if (!armed && !faulty)
        notice_->showNote(tr("Stopped: the device gets no force. Device > Forces on goes on."));
    else if (armed && (faulty || notice_->property("severity") == QLatin1String("note")))
        notice_->hide();
}

void MainWindow::showArmed(bool armed) {
    actions_["armed"].setChecked(armed);
    actions_["stop"].setEnabled(armed);
}

void MainWindow::frame() {
    engine_.poll();
    if (shared_) shared_->frame();
    saver_->watch(); // before a fault switches the forces off
    watchHealth();
    watchDevice();
    if (study_->running()) return studyFrame();
    showPlots();
    if (playback_->active()) return playFrame();
    hand_->follow();
    if (view_->isVisible())
        view_->setHaptics(engine_.proxy(), engine_.servo(), engine_.device().maxForce, engine_.armed());
    const World* world = publisher_.world().get();
    const bool known = world && engine_.proxy().worldRevision == world->revision;
    showTouched(known ? world : nullptr, trial_ && world ? *world->scene : document_.scene());
    drawTrace();
    status_->display(engine_);
}

/// `scene`: as the world was made of it, but with the names of now.
void MainWindow::showTouched(const World* world, const Scene& scene) {
    const HapticOutput& touch =
        playback_->active() ? playback_->player().proxy().output : engine_.proxy().output;
    const auto now = world ? touchedSurface(touch, *world) : std::nullopt;
    touchedName_ = now ? nameOfSurface(scene, *now) : QString();
    view_->setTouched(touchedName_);
    status_->setTouched(touchedName_);
    if (now && !trial_ && !playback_->active()) touched_ = now;
}

void MainWindow::selectTouched() {
    if (touched_ && document_.surface(*touched_)) return document_.select(*touched_);
    notice_->showNote(tr("Nothing has been touched yet: drag on the model."));
}

// The frame and the title of the window take some of it.
QSize MainWindow::firstSize(QSize room) {
    return QSize(1920, 1080).boundedTo(room - QSize(0, 5 * kRhythm));
}

void MainWindow::restore() {
    resize(firstSize(screen()->availableSize()));
    QSettings settings;
    restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
    restoreState(settings.value(QStringLiteral("window/state")).toByteArray());
    restoreFolds();
    setWindowTitle(tr("Tactum"));
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (study_->running() || studyDesk_->modified()) {
        event->ignore();
        if (study_->running()) return studyPage_->askToEnd();
        return leaveStudy([this] { close(); });
    }
    QSettings settings;
    settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
    settings.setValue(QStringLiteral("window/state"), shownPanels_.isEmpty() ? saveState() : shownPanels_);
    saveFolds();
    saver_->flush();
    if (leaving_ || !document_.modified()) {
        engine_.setArmed(false);
        journal_->discard();
        return QMainWindow::closeEvent(event);
    }
    event->ignore();
    leave(tr("closing"), [this] {
        leaving_ = true;
        close();
    });
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!firstFile(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dragMoveEvent(QDragMoveEvent* event) {
    const bool lights = isPicture(firstFile(*event->mimeData())) && view_->isVisible();
    if (lights) view_->light(view_->mapFrom(this, event->position()));
    event->acceptProposedAction();
}

void MainWindow::dragLeaveEvent(QDragLeaveEvent*) {
    view_->endLight();
}

void MainWindow::dropEvent(QDropEvent* event) {
    event->acceptProposedAction();
    const QString file = firstFile(*event->mimeData());
    if (isPicture(file)) return dropPicture(file, event->position());
    const QPointF at = view_->mapFrom(this, event->position());
    if (!presets_->take(file, view_->isVisible() ? view_->surfaceAt(at) : std::nullopt))
        dropModels(filesIn(*event->mimeData()));
}

} // namespace tactum
