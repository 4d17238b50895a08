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

#include "core/scene/primitives.h"
#include "ui/controllers/arming.h"
#include "ui/controllers/arrange_controller.h"
#include "ui/controllers/cameras_menu.h"
#include "ui/controllers/compare_controller.h"
#include "ui/controllers/covers.h"
#include "ui/controllers/device_controller.h"
#include "ui/controllers/edit_notice.h"
#include "ui/controllers/felt_controller.h"
#include "ui/controllers/folds.h"
#include "ui/controllers/geometry_controller.h"
#include "ui/controllers/group_controller.h"
#include "ui/controllers/health_controller.h"
#include "ui/controllers/import_controller.h"
#include "ui/controllers/layer_controller.h"
#include "ui/controllers/loupe_controller.h"
#include "ui/controllers/measure_controller.h"
#include "ui/controllers/motion_controller.h"
#include "ui/controllers/paint_controller.h"
#include "ui/controllers/palette_controller.h"
#include "ui/controllers/parts_controller.h"
#include "ui/controllers/plot_controller.h"
#include "ui/controllers/preference_controller.h"
#include "ui/controllers/presentation_controller.h"
#include "ui/controllers/preset_controller.h"
#include "ui/controllers/problem_controller.h"
#include "ui/controllers/recent_controller.h"
#include "ui/controllers/recording_controller.h"
#include "ui/controllers/recovery_controller.h"
#include "ui/controllers/report_controller.h"
#include "ui/controllers/room_controller.h"
#include "ui/controllers/rumble_controller.h"
#include "ui/controllers/save_controller.h"
#include "ui/controllers/section_controller.h"
#include "ui/controllers/select_controller.h"
#include "ui/controllers/self_test_controller.h"
#include "ui/controllers/sound_controller.h"
#include "ui/controllers/split_controller.h"
#include "ui/controllers/stage.h"
#include "ui/controllers/study_controller.h"
#include "ui/controllers/surface_controller.h"
#include "ui/controllers/trial_controller.h"
#include "ui/controllers/video_controller.h"
#include "ui/document/journal.h"
#include "ui/document/layer_edits.h"
#include "ui/document/recovery.h"
#include "ui/engine/device_link.h"
#include "ui/engine/guard_watch.h"
#include "ui/engine/shared_link.h"
#include "ui/engine/touched.h"
#include "ui/panels/body_panel.h"
#include "ui/panels/connection_bar.h"
#include "ui/panels/device_panel.h"
#include "ui/panels/health_panel.h"
#include "ui/panels/import_bar.h"
#include "ui/panels/inspector.h"
#include "ui/panels/layer_panel.h"
#include "ui/panels/place_panel.h"
#include "ui/panels/recovery_bar.h"
#include "ui/panels/start_page.h"
#include "ui/panels/status_strip.h"
#include "ui/rumble/rumble_link.h"
#include "ui/showing/playback.h"
#include "ui/showing/playback_bar.h"
#include "ui/showing/played_touch.h"
#include "ui/showing/recording_saver.h"
#include "ui/sound/sound_link.h"
#include "ui/study/study_desk.h"
#include "ui/study/study_page.h"
#include "ui/study/study_session.h"
#include "ui/tools/arrange_tool.h"
#include "ui/tools/hand_link.h"
#include "ui/tools/paint_tool.h"
#include "ui/tools/touch_hint.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/force_plot.h"
#include "ui/widgets/notice_bar.h"
#include "ui/widgets/tool_strip.h"

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
      view_(new SceneView), selectStrip_(new ToolStrip), arranging_(new ArrangeTool(document, *view_, this)),
      arrangeStrip_(new ToolStrip), painting_(new PaintTool(document, *view_, this)),
      paintStrip_(new ToolStrip), notice_(new NoticeBar), centre_(new QStackedWidget),
      start_(new StartPage(samples)), playbackBar_(new PlaybackBar), connection_(new ConnectionBar),
      importBar_(new ImportBar), status_(new StatusStrip), hint_(new TouchHint(view_)),
      hand_(new HandLink(*view_, engine, std::move(hand), this)), guard_(new GuardWatch(engine, this)),
      playback_(new Playback(*playbackBar_, this)), saver_(new RecordingSaver(engine, document, this)),
      journal_(new Journal(document, this)), recovery_(new Recovery(document, *journal_, this)),
      recoveryBar_(new RecoveryBar(*recovery_)), studyPage_(new StudyPage), sound_(new SoundLink(this)),
      rumble_(new RumbleLink(this)), link_(new DeviceLink(engine, this)),
      told_(new EditNotice(document, *notice_, this)), bench_{*this,      document_, engine_,
                                                              publisher_, actions_,  *view_,
                                                              *notice_,   *told_,    *playback_},
      arming_(new Arming(engine, actions_, *view_, *notice_, *guard_, *link_, this)),
      stage_(new Stage(document, *view_, *centre_, *start_, this)),
      save_(new SaveController(bench_, samples)), samples_(samples) {
    view_->setTheme(theme().dark);
    setCentralWidget(makeCentre());
    docks_ = addDocks(*this, document);
    addTabBeside(*this, bench_.dock("dock-body"), QStringLiteral("dock-place"), tr("Place"),
                 new PlacePanel(document, *arranging_));
    compare_ = new CompareController(bench_);
    study_ = new StudyController(bench_, *arming_, *stage_, *hand_, *studyPage_);
    presets_ = new PresetController(bench_);
    devicePanel_ = new DevicePanel(*link_);
    addTabBeside(*this, bench_.dock("dock-inspector"), QStringLiteral("dock-device"), tr("Device"),
                 devicePanel_);
    bench_.dock("dock-inspector").raise();
    sizeDocks(*this);
    folds_ = new Folds(*this);
    parts_ = new PartsController(bench_, *arranging_, *hand_, *docks_.outliner, samples);
    makeToolBars();
    makeMenus();
    statusBar()->setSizeGripEnabled(false);
    statusBar()->addWidget(status_, 1);
    connectFile();
    connectEdit();
    connectView();
    connect(stage_, &Stage::otherShown, new SectionController(bench_), &SectionController::makeWhole);
    new MeasureController(bench_);
    connect(stage_, &Stage::otherShown, view_, &SceneView::clearMeasure);
    cameras_ = new CamerasMenu(bench_);
    new GroupController(bench_);
    connectSelecting();
    new ArrangeController(bench_, *arranging_, *arrangeStrip_);
    new SurfaceController(bench_, *docks_.inspector);
    new LoupeController(bench_);
    new SplitController(bench_);
    felt_ = new FeltController(bench_);
    new PlotController(bench_, *docks_.plot);
    new SoundController(bench_, *sound_);
    new RumbleController(bench_, *rumble_);
    connectDocument();
    connectParts();
    presentation_ = new PresentationController(bench_);
    new VideoController(bench_, *docks_.plot);
    makeControllers();
    new Covers(*centralWidget(), *view_);
    setAcceptDrops(true);
    plain_.reset();
    restore();
    follow({});
    connect(&frames_, &QTimer::timeout, this, &MainWindow::frame);
    frames_.start(kFrame);
}

MainWindow::~MainWindow() = default;

Comparison& MainWindow::comparison() {
    return compare_->comparison();
}

StudyDesk& MainWindow::studyDesk() {
    return study_->desk();
}

StudySession& MainWindow::study() {
    return study_->session();
}

void MainWindow::setCatalogue(DeviceCatalogue& catalogue) {
    link_->setCatalogue(catalogue);
    devices_->showCommands();
}

/// Scenes that begin anew, and objects of which more is wanted.
void MainWindow::connectParts() {
    for (const auto& [id, ground] : {std::pair{"new", false}, {"new-ground", true}})
        bench_.on(id, this, [this, onGround = ground] {
            save_->leave(tr("beginning a new scene"), [this, onGround] {
                playback_->end();
                document_.begin(onGround ? sceneOf(Primitive::Ground) : Scene());
            });
        });
    connect(start_, &StartPage::newRequested, &actions_["new-ground"], &QAction::trigger);
    connect(parts_, &PartsController::opens, this, &MainWindow::open);
    connect(view_, &SceneView::menuAsked, this, [this](const std::optional<PickHit>& hit, const QPoint& at) {
        if (!playback_->active() && !study_->running()) parts_->askInView(hit, at);
    });
}

/// Those that nobody here asks anything of, and what they tell each other.
void MainWindow::makeControllers() {
    auto* recent = new RecentController(bench_, start_->recent());
    connect(save_, &SaveController::filesChanged, recent, &RecentController::show);
    room_ = new RoomController(bench_, *folds_);
    connect(centre_, &QStackedWidget::currentChanged, room_, &RoomController::leaveStart);
    makeLive();
    layers_ = new LayerController(bench_, *docks_.layers);
    new PaintController(bench_, *painting_, *paintStrip_, *docks_.layers);
    new ProblemController(bench_, *docks_.problems);
    new ImportController(bench_, *importBar_, *playbackBar_, *hint_);
    new GeometryController(bench_);
    new MotionController(bench_, *docks_.body, *folds_);
    new ReportController(bench_, *guard_, samples_);
    connect(journal_, &Journal::failed, notice_, &NoticeBar::showError);
    connect(new RecoveryController(bench_, *recovery_, *recoveryBar_), &RecoveryController::replaces, save_,
            &SaveController::leave);
    recovery_->look();
    connect(new PaletteController(bench_, *folds_, *sets_, *cameras_, *centre_, *importBar_),
            &PaletteController::fileChosen, this, &MainWindow::open);
    auto* preferences = new PreferenceController(bench_, *journal_);
    connect(preferences, &PreferenceController::themeChanged, recent, &RecentController::show);
    connect(preferences, &PreferenceController::themeChanged, this, &MainWindow::refreshMore);
}

/// What concerns the hand, the device and the forces: what is felt in the document's place gives way to each
/// other.
void MainWindow::makeLive() {
    trial_ = new TrialController(bench_, *arming_, *stage_, *hand_, devicePanel_->trial());
    connect(link_, &DeviceLink::exchanged, trial_,
            &TrialController::end); // it was laid out for the other one
    devices_ = new DeviceController(bench_, *arming_, *link_, *hand_, *hint_, *folds_, *devicePanel_);
    selfTest_ = new SelfTestController(bench_, *link_);
    health_ = new HealthController(bench_, *arming_, *guard_, *docks_.health, *docks_.inspector, *status_);
    connect(devices_, &DeviceController::adopted, health_, &HealthController::adoptDevice);
    connect(devices_, &DeviceController::handChosen, this, [this] {
        view_->clearTrail();
        docks_.plot->clear();
    });
    connect(trial_, &TrialController::asked, devices_,
            [this] { devices_->showPage(int(DevicePanel::Page::Trial)); });
    connect(link_, &DeviceLink::letsGo, saver_, &RecordingSaver::flush);
    connect(saver_, &RecordingSaver::saved, this, &MainWindow::sayRecorded);
    connect(study_, &StudyController::begins, trial_, &TrialController::end);
    connect(study_, &StudyController::begins, hint_, &QWidget::hide);
    connect(study_, &StudyController::ended, this, [this] {
        felt_->show();
        docks_.plot->clear();
    });
    connect(&publisher_, &WorldPublisher::published, this, [this] {
        // In a study the view keeps the first one: what is seen does not say what is felt.
        const bool blind = study_->running() && study_->session().run().step() != StudyStep::Instructions;
        if (!playback_->active() && !blind) view_->setWorld(publisher_.world());
    });
    connect(playback_, &Playback::begun, trial_, &TrialController::end);
    auto* recordings = new RecordingController(bench_, *arming_, *stage_, *hand_, *arranging_, *saver_);
    connect(recordings, &RecordingController::liveChanged, this, [this](bool live) {
        if (live) compare_->showCommands();
        devices_->showCommands();
        study_->showCommands();
    });
    connect(recordings, &RecordingController::shown, this, [this] {
        shownShape_ = 0;
        playFrame();
        health_->showOf(true);
    });
    connect(playback_, &Playback::ended, this, [this] {
        health_->showOf(false);
        docks_.plot->clear();
    });
}

QWidget* MainWindow::makeCentre() {
    auto* body = new QWidget;
    // Over the view, not above it: what comes by itself, or with a key, must not move the model under the
    // pointer that is about to press on it.
    auto* layers = new QGridLayout(body);
    layers->setContentsMargins(0, 0, 0, 0);
    layers->addWidget(centre_, 0, 0);
    auto* head = new QVBoxLayout;
    head->setSpacing(0);
    auto* strips = new QVBoxLayout;
    strips->setObjectName(QStringLiteral("strips")); // Workbench::strips() knows it by that
    strips->setSpacing(0);
    for (ToolStrip* strip : {selectStrip_, arrangeStrip_, paintStrip_})
        strips->addWidget(strip, 0, Qt::AlignLeft);
    head->addLayout(strips);
    head->addWidget(recoveryBar_); // below: a button must not go away under the pointer
    head->addWidget(notice_);
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
    view_->setFocusPolicy(Qt::StrongFocus);
    view_->setAccessibleName(tr("Model and finger"));
    return body;
}

void MainWindow::open(const QString& file) {
    if (isRecording(file)) return playback_->open(file);
    save_->leave(tr("opening %1").arg(QFileInfo(file).fileName()), [this, file] {
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
    trial_->end();
    if (change.what == What::Selection) return selecting_->showSelection();
    if (change.what == What::ProxyRadius) return view_->setProxyRadius(document_.scene().proxyRadius);
    if (change.what == What::Material) return view_->setLooks(document_.scene());
    // The World from before knows other objects by the same numbers.
    if (change.what == What::Everything) view_->setWorld(nullptr);
    if (change.what == What::Bodies) view_->setCasters(document_.scene());
    if (change.touchesShape()) {
        touched_.reset(); // its number may be another surface's now
        view_->setScene(document_.scene());
        view_->setProxyRadius(document_.scene().proxyRadius);
    }
    if (change.what == What::Everything) {
        stage_->showCentre(); // or the view would not know yet how large it is
        view_->fitAll();
        hand_->placeBeside();
    }
    for (const char* id : {"save", "save-as", "export", "save-picture", "update-geometry", "export-report"})
        actions_[id].setEnabled(!document_.empty());
    stage_->showCentre();
}

void MainWindow::showOpened() {
    save_->showFile();
    view_->planViews();
    hand_->placeBeside();
    view_->setFocus();
    offerHint();
}

/// Where it is true: with something to touch, by the mouse.
void MainWindow::offerHint() {
    hint_->hide();
    if (actions_["touch"].isChecked() && !document_.empty() && !hand_->idle()) hint_->offer();
}

void MainWindow::frame() {
    engine_.poll();
    link_->follow();
    if (shared_) shared_->frame();
    saver_->watch(); // before a fault switches the forces off
    health_->frame();
    devices_->frame();
    selfTest_->frame();
    if (study_->running()) return study_->frame();
    room_->frame();
    if (playback_->active()) return playFrame();
    hand_->follow();
    if (view_->isVisible()) devices_->showHands();
    if (view_->isVisible())
        view_->setHaptics(engine_.proxy(), engine_.servo(), engine_.device().maxForce, engine_.armed());
    const World* world = publisher_.world().get();
    const bool known = world && engine_.proxy().worldRevision == world->revision;
    showTouched(known ? world : nullptr, trial_->running() && world ? *world->scene : document_.scene());
    drawTrace();
    status_->setOthersPush(link_->hands().anyArmed());
    status_->display(engine_);
}

void MainWindow::drawTrace() {
    trace_.clear();
    for (TracePoint point; engine_.popTrace(point);)
        trace_.push_back(point);
    docks_.plot->take(trace_, engine_.proxy().output, engine_.device().maxForce, engine_.proxy().rate,
                      view_->readingOf(engine_.proxy(), docks_.body->body()), touchedName_);
    view_->addTrail(trace_, engine_.proxy().output);
    playTouch(trace_, engine_.device().rate);
    docks_.layers->take(trace_, engine_.proxy().time);
}

/// To whatever else can play what is felt.
void MainWindow::playTouch(const std::vector<TracePoint>& points, double rate) {
    sound_->play(points, rate);
    rumble_->play(points, rate);
}

void MainWindow::playFrame() {
    playback_->frame();
    Player& player = playback_->player();
    const std::size_t hand = playback_->hand();
    if (const World* world = player.world(); world && world->shapeRevision != shownShape_) {
        shownShape_ = world->shapeRevision;
        view_->setScene(*world->scene);
    }
    if (view_->isVisible()) showPlayedHands(player, hand, *view_);
    view_->setWorld(player.sharedWorld());
    if (playback_->takeJump()) {
        docks_.plot->clear();
        view_->clearTrail();
    }
    if (const World* world = player.world()) showTouched(world, *world->scene);
    playTouch(showPlayed(player, hand, *docks_.plot, *view_, touchedName_),
              player.run().hand(hand).device.rate);
    for (TracePoint live; engine_.popTrace(live);)
        continue;
    status_->display(player.proxy(), player.servo(hand), player.run().hand(hand).device);
}

void MainWindow::sayRecorded(const QString& file, bool afterFault) {
    const bool live = !playback_->active();
    const QString kept = tr("What led to it was saved: %1.").arg(file);
    if (afterFault && link_->lost() && live) return devices_->sayAway(kept);
    if (arming_->faulty() && live) return arming_->offer(kept);
    notice_->showNote(
        afterFault ? tr("There was a fault. What led to it was saved: open %1 to see it again.").arg(file)
                   : tr("The last minute was saved to %1.").arg(file));
}

/// `scene`: as the world was made of it, but with the names of now.
void MainWindow::showTouched(const World* world, const Scene& scene) {
    const HapticOutput& touch =
        playback_->active() ? playback_->player().proxy().output : engine_.proxy().output;
    const auto now = world ? touchedSurface(touch, *world) : std::nullopt;
    touchedName_ = now ? nameOfSurface(scene, *now) : QString();
    view_->setTouched(touchedName_);
    status_->setTouched(touchedName_);
    if (now && !trial_->running() && !playback_->active()) touched_ = now;
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
    room_->restore();
    room_->clearForStart();
    setWindowTitle(tr("Tactum"));
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (study_->keepsOpen()) return event->ignore();
    room_->save();
    saver_->flush();
    if (leaving_ || !document_.modified()) {
        link_->hands().setAllArmed(false);
        journal_->discard();
        return QMainWindow::closeEvent(event);
    }
    event->ignore();
    save_->leave(tr("closing"), [this] {
        leaving_ = true;
        close();
    });
}

/// What nobody else wanted.
void MainWindow::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && !event->isAutoRepeat() && presentation_->leave()) return;
    QMainWindow::keyPressEvent(event);
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
    if (isPicture(file)) return layers_->drop(file, event->position());
    const QPointF at = view_->mapFrom(this, event->position());
    if (!presets_->take(file, view_->isVisible() ? view_->surfaceAt(at) : std::nullopt))
        parts_->drop(filesIn(*event->mimeData()));
}

} // namespace tactum
