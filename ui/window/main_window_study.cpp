// Studies in the window: the dock and its commands, and the page that a participant sees instead of
// everything else.
#include "ui/window/main_window.h"

#include <QAction>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QInputDialog>
#include <QMenuBar>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QStatusBar>
#include <QToolBar>

#include "ui/base/ask_where.h"
#include "ui/base/words.h"
#include "ui/engine/guard_watch.h"
#include "ui/panels/import_bar.h"
#include "ui/showing/playback.h"
#include "ui/study/study_desk.h"
#include "ui/study/study_dialog.h"
#include "ui/study/study_page.h"
#include "ui/study/study_panel.h"
#include "ui/study/study_session.h"
#include "ui/tools/hand_link.h"
#include "ui/tools/touch_hint.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/force_plot.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

namespace {

QString studyEnding() {
    return asIs(kStudyEnding);
}

/// Names of surfaces, each once.
QStringList surfacesOf(const std::vector<Scene>& conditions) {
    QStringList names;
    for (const Scene& scene : conditions)
        for (const SceneObject& object : scene.objects)
            for (const Surface& surface : object.surfaces)
                if (const QString name = QString::fromStdString(surface.name);
                    !name.isEmpty() && !names.contains(name))
                    names << name;
    return names;
}

StudyMoment momentOf(const StudySession& study, const Engine& engine) {
    return {study.felt(), study.waitsForLift(), engine.armed(), study.rests()};
}

/// The touch as a participant may see it: the finger lies on the surface, so that neither depth nor arrow
/// tells the force, and no word says whether it sticks or slips.
void showBlind(SceneView& view, const Engine& engine) {
    ProxyTelemetry proxy = engine.proxy();
    ServoTelemetry servo = engine.servo();
    servo.finger = proxy.output.proxy;
    servo.force = proxy.output.force = Vec3::Zero();
    proxy.output.contacts = 0;
    view.setHaptics(proxy, servo, engine.device().maxForce, engine.armed());
}

} // namespace

void MainWindow::addStudyDock() {
    studyPanel_ = new StudyPanel(*studyDesk_);
    addTabBeside(*this, *findChild<QDockWidget*>(QStringLiteral("dock-health")), QStringLiteral("dock-study"),
                 tr("Study"), studyPanel_);
}

void MainWindow::connectStudy() {
    const auto on = [this](const char* id, auto act) {
        connect(&actions_[id], &QAction::triggered, this, act);
    };
    on("study-new", [this] { leaveStudy([this] { studyDesk_->begin(); }); });
    on("study-open", [this] { leaveStudy([this] { askForStudy(); }); });
    on("study-save", [this] { saveStudy({}); });
    on("study-keep", [this] { keepState(); });
    on("study-replace", [this] { studyDesk_->replace(studyPanel_->chosen()); });
    on("study-show", [this] { studyDesk_->show(studyPanel_->chosen()); });
    on("study-remove", [this] { studyDesk_->remove(studyPanel_->chosen()); });
    on("study-edit", [this] { editStudy(); });
    on("study-run", [this] { askToRunStudy(); });
    const std::pair<void (StudyPanel::*)(), const char*> asked[] = {
        {&StudyPanel::keepAsked, "study-keep"}, {&StudyPanel::replaceAsked, "study-replace"},
        {&StudyPanel::showAsked, "study-show"}, {&StudyPanel::removeAsked, "study-remove"},
        {&StudyPanel::editAsked, "study-edit"}, {&StudyPanel::runAsked, "study-run"}};
    for (const auto& [signal, id] : asked)
        connect(studyPanel_, signal, &actions_[id], &QAction::trigger);
    connect(studyPanel_, &StudyPanel::chosenChanged, this, &MainWindow::showStudyCommands);
    connect(studyDesk_, &StudyDesk::changed, this, &MainWindow::showStudyCommands);
    connect(studyDesk_, &StudyDesk::failed, notice_, &NoticeBar::showError);
    connect(&document_, &Document::changed, this, &MainWindow::showStudyCommands);
    connectStudyPage();
    showStudyCommands();
}

void MainWindow::connectStudyPage() {
    connect(studyPage_, &StudyPage::proceeded, this, &MainWindow::proceedStudy);
    connect(studyPage_, &StudyPage::againWanted, study_, &StudySession::feelAgain);
    connect(studyPage_, &StudyPage::chosen, study_, &StudySession::choose);
    connect(studyPage_, &StudyPage::replied, study_, &StudySession::reply);
    connect(studyPage_, &StudyPage::endWanted, this, &MainWindow::endStudy);
    connect(studyPage_, &StudyPage::forcesWanted, this, [this] { armForStudy(); });
    connect(studyPage_, &StudyPage::leavesViewChanged, this, [this](bool leaves) {
        centralWidget()->layout()->setAlignment(studyPage_, leaves ? Qt::AlignTop : Qt::Alignment());
        if (!leaves) view_->endTouch(); // or the hand would stay where it presses
    });
    connect(study_, &StudySession::changed, this, &MainWindow::showStudyStep);
    connect(study_, &StudySession::refused, studyPage_, &StudyPage::refuse);
    connect(study_, &StudySession::finished, this, &MainWindow::switchOff);
    connect(study_, &StudySession::failed, this, [this](const QString& sentence) {
        endStudy();
        notice_->showError(tr("The study has ended: %1").arg(sentence));
    });
    connect(study_, &StudySession::forcesWanted, this, [this](bool on) {
        if (!on)
            switchOff();
        else if (!guard_->fault())
            armForStudy();
    });
}

void MainWindow::showStudyCommands() {
    const bool live = !playback_->active() && !study_->running();
    const bool chosen = studyPanel_->chosen() >= 0;
    actions_["study-keep"].setEnabled(live && !document_.empty());
    studyPanel_->setSceneThere(live && !document_.empty());
    for (const char* id : {"study-replace", "study-show", "study-remove"})
        actions_[id].setEnabled(live && chosen);
    actions_["study-save"].setEnabled(!studyDesk_->study().conditions.empty());
    actions_["study-run"].setEnabled(live && check(studyDesk_->study().design).has_value());
}

/// Goes on where nothing would be lost by it; else says what would be, with a way to do so.
void MainWindow::leaveStudy(std::function<void()> goOn) {
    if (!studyDesk_->modified()) return goOn();
    notice_->offer(tr("The study has not been saved. Study > Save the study as... keeps it."),
                   QStringLiteral("note"), tr("Go on without it"), [this, goOn = std::move(goOn)] {
                       studyDesk_->begin();
                       goOn();
                   });
}

void MainWindow::askForStudy() {
    const QString file = QFileDialog::getOpenFileName(this, tr("Open a study"), studyDesk_->file(),
                                                      tr("Studies (*.%1)").arg(studyEnding()));
    if (!file.isEmpty()) studyDesk_->open(file);
}

void MainWindow::saveStudy(std::function<void()> after) {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    const QString now = studyDesk_->file().isEmpty() ? folder + QStringLiteral("/study.") + studyEnding()
                                                     : studyDesk_->file();
    const QString file = askWhere(this, tr("Save the study"), {{tr("Studies"), studyEnding()}}, now);
    if (file.isEmpty()) return;
    studyDesk_->save(file, [this, file, after = std::move(after)] {
        notice_->showNote(tr("The study was saved to %1.").arg(file));
        if (after) after();
    });
}

void MainWindow::keepState() {
    const int count = int(studyDesk_->study().conditions.size());
    bool agreed = false;
    const QString name = QInputDialog::getText(this, tr("Keep this state"), tr("Name of the condition"),
                                               QLineEdit::Normal, tr("State %1").arg(count + 1), &agreed);
    if (agreed && !studyDesk_->keep(name))
        notice_->showError(
            tr("A condition needs a name of its own, and there may be %1 of them.").arg(kMaxConditions));
    findChild<QDockWidget*>(QStringLiteral("dock-study"))->raise();
}

void MainWindow::editStudy() {
    const Study& study = studyDesk_->study();
    if (const auto design = askForDesign(this, study.design, surfacesOf(study.conditions)))
        studyDesk_->setDesign(*design);
}

/// As it is saved: the logs name the file by its fingerprint.
void MainWindow::askToRunStudy() {
    const auto ask = [this] {
        const auto start = askForStart(this, studyDesk_->study().design, studyDesk_->file());
        if (start) beginStudy(*start);
    };
    if (studyDesk_->file().isEmpty()) return saveStudy(ask);
    if (!studyDesk_->modified()) return ask();
    studyDesk_->save(studyDesk_->file(), ask);
}

void MainWindow::beginStudy(const StudyStart& start) {
    playback_->end();
    endTrial();
    switchOff();
    const auto study = std::make_shared<const Study>(studyDesk_->study());
    if (const auto begun = study_->begin(study, start); !begun)
        return notice_->showError(QString::fromStdString(begun.error().text));
    hideForStudy();
    const Scene& scene = study->conditions[0]; // whatever is felt: what is seen tells nothing
    view_->setSelection({});
    view_->setTouched({});
    view_->setScene(scene);
    view_->setProxyRadius(scene.proxyRadius);
    view_->fit();
    hand_->placeBeside();
}

/// All that tells what is felt, and all that could change it.
void MainWindow::hideForStudy() {
    actions_["touch"].trigger();
    for (const Command& command : commands())
        if (QAction& action = actions_[command.id]; action.isEnabled()) {
            action.setEnabled(false);
            studyOff_.push_back(&action);
        }
    studyHidPanels_ = shownPanels_.isEmpty();
    if (studyHidPanels_) hidePanels(true);
    for (QWidget* each : {static_cast<QWidget*>(menuBar()),
                          static_cast<QWidget*>(findChild<QToolBar*>(QStringLiteral("tools"))),
                          static_cast<QWidget*>(statusBar()), static_cast<QWidget*>(importBar_)})
        if (each->isVisible()) {
            each->hide();
            studyHid_.push_back(each);
        }
    notice_->hide();
    hint_->hide();
    setAcceptDrops(false);
    centre_->setCurrentWidget(view_);
    view_->setFocusPolicy(Qt::NoFocus); // keys are the page's
    view_->setOverlayVisible(study_->run().design().view == StudyView::Shown);
    FeltOptions nothing;
    nothing.normals = nothing.planes = false;
    view_->setFelt(nothing);
    view_->clearTrail();
    studyPage_->raise();
    activateWindow(); // after the dialog
    studyPage_->setFocus();
}

void MainWindow::showAfterStudy() {
    for (QAction* action : std::exchange(studyOff_, {}))
        action->setEnabled(true);
    for (QWidget* each : std::exchange(studyHid_, {}))
        each->show();
    if (std::exchange(studyHidPanels_, false)) hidePanels(false);
    setAcceptDrops(true);
    view_->setFocusPolicy(Qt::StrongFocus);
    view_->setOverlayVisible(actions_["overlay"].isChecked());
    showFelt();
    studyPage_->hide();
    view_->setFocus();
}

/// Safe to call when the run has ended by itself. Forces off: the finger may be inside of the author's model.
void MainWindow::endStudy() {
    study_->end();
    if (studyPage_->isHidden()) return;
    switchOff();
    showAfterStudy();
    showOwnScene();
    showStudyCommands();
    docks_.plot->clear();
    notice_->showNote(tr("The answers are in %1, the touch beside them. The forces are off.")
                          .arg(QString::fromStdU16String(study_->answers().u16string())));
}

void MainWindow::armForStudy() {
    guard_->setArmed(true);
    showArmed(true);
    actions_["stop"].setEnabled(false); // as all commands
}

void MainWindow::proceedStudy() {
    if (!study_->running() || study_->run().step() == StudyStep::Done) return endStudy();
    if (study_->run().step() == StudyStep::Instructions) armForStudy();
    study_->proceed();
}

void MainWindow::showStudyStep() {
    if (study_->running()) studyPage_->display(study_->run(), momentOf(*study_, engine_));
}

/// Once a frame, instead of all else that is drawn.
void MainWindow::studyFrame() {
    hand_->follow();
    trace_.clear();
    for (TracePoint point; engine_.popTrace(point);)
        trace_.push_back(point);
    study_->take(trace_);
    if (!study_->running()) return;
    const StudyStep step = study_->run().step();
    const bool moves =
        step == StudyStep::Stimulus || step == StudyStep::Pause; // a question keeps what is typed
    if (moves && studyPage_->moment() != momentOf(*study_, engine_)) showStudyStep();
    if (study_->run().design().view == StudyView::Shown && view_->isVisible()) showBlind(*view_, engine_);
}

} // namespace tactum
