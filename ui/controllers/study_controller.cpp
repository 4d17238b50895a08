#include "ui/controllers/study_controller.h"

#include <QAction>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QInputDialog>
#include <QMenuBar>
#include <QStandardPaths>
#include <QStatusBar>
#include <QToolBar>

#include "ui/base/ask_where.h"
#include "ui/base/words.h"
#include "ui/controllers/arming.h"
#include "ui/controllers/docks.h"
#include "ui/controllers/stage.h"
#include "ui/document/document.h"
#include "ui/panels/import_bar.h"
#include "ui/showing/playback.h"
#include "ui/study/study_desk.h"
#include "ui/study/study_dialog.h"
#include "ui/study/study_page.h"
#include "ui/study/study_panel.h"
#include "ui/study/study_session.h"
#include "ui/tools/hand_link.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

namespace {

QString studyEnding() {
    return asIs(kStudyEnding);
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
    view.setHands({}, {});
    view.setHaptics(proxy, servo, engine.device().maxForce, engine.armed());
}

} // namespace

StudyController::StudyController(const Workbench& bench, Arming& arming, Stage& stage, HandLink& hand,
                                 StudyPage& page)
    : QObject(&bench.window), bench_(bench), arming_(arming), stage_(stage), hand_(hand), page_(page),
      desk_(new StudyDesk(bench.document, this)),
      study_(new StudySession(bench.publisher, bench.engine, this)), panel_(new StudyPanel(*desk_)) {
    addTabBeside(bench.window, bench.dock("dock-health"), QStringLiteral("dock-study"), tr("Study"), panel_);
    connectCommands();
    connect(panel_, &StudyPanel::chosenChanged, this, &StudyController::showCommands);
    connect(desk_, &StudyDesk::changed, this, &StudyController::showCommands);
    connect(desk_, &StudyDesk::failed, &bench.notice, &NoticeBar::showError);
    connect(&bench.document, &Document::changed, this, &StudyController::showCommands);
    connectPage();
    connectSession();
    showCommands();
}

void StudyController::connectCommands() {
    bench_.on("study-new", this, [this] { leave([this] { desk_->begin(); }); });
    bench_.on("study-open", this, [this] { leave([this] { askForFile(); }); });
    bench_.on("study-save", this, [this] { save({}); });
    bench_.on("study-keep", this, [this] { keepState(); });
    bench_.on("study-replace", this, [this] { desk_->replace(panel_->chosen()); });
    bench_.on("study-show", this, [this] { desk_->show(panel_->chosen()); });
    bench_.on("study-remove", this, [this] { desk_->remove(panel_->chosen()); });
    bench_.on("study-edit", this, [this] { edit(); });
    bench_.on("study-run", this, [this] { askToRun(); });
    const std::pair<void (StudyPanel::*)(), const char*> asked[] = {
        {&StudyPanel::keepAsked, "study-keep"}, {&StudyPanel::replaceAsked, "study-replace"},
        {&StudyPanel::showAsked, "study-show"}, {&StudyPanel::removeAsked, "study-remove"},
        {&StudyPanel::editAsked, "study-edit"}, {&StudyPanel::runAsked, "study-run"}};
    for (const auto& [signal, id] : asked)
        connect(panel_, signal, &bench_.actions[id], &QAction::trigger);
}

void StudyController::connectPage() {
    connect(&page_, &StudyPage::proceeded, this, &StudyController::proceed);
    connect(&page_, &StudyPage::againWanted, study_, &StudySession::feelAgain);
    connect(&page_, &StudyPage::chosen, study_, &StudySession::choose);
    connect(&page_, &StudyPage::replied, study_, &StudySession::reply);
    connect(&page_, &StudyPage::endWanted, this, &StudyController::end);
    connect(&page_, &StudyPage::forcesWanted, this, &StudyController::arm);
    connect(&page_, &StudyPage::leavesViewChanged, this, [this](bool leaves) {
        bench_.window.centralWidget()->layout()->setAlignment(&page_,
                                                              leaves ? Qt::AlignTop : Qt::Alignment());
        if (!leaves) bench_.view.endTouch(); // or the hand would stay where it presses
    });
}

void StudyController::connectSession() {
    connect(study_, &StudySession::changed, this, &StudyController::showStep);
    connect(study_, &StudySession::refused, &page_, &StudyPage::refuse);
    connect(study_, &StudySession::finished, &arming_, &Arming::switchOff);
    connect(study_, &StudySession::failed, this, [this](const QString& sentence) {
        end();
        bench_.notice.showError(tr("The study has ended: %1").arg(sentence));
    });
    connect(study_, &StudySession::forcesWanted, this, [this](bool on) {
        if (!on)
            arming_.switchOff();
        else if (!arming_.faulty())
            arm();
    });
}

bool StudyController::running() const {
    return study_->running();
}

bool StudyController::keepsOpen() {
    if (study_->running()) {
        page_.askToEnd();
        return true;
    }
    if (!desk_->modified()) return false;
    leave([this] { bench_.window.close(); });
    return true;
}

void StudyController::showCommands() {
    const bool live = !bench_.playback.active() && !study_->running();
    const bool chosen = panel_->chosen() >= 0;
    bench_.actions["study-keep"].setEnabled(live && !bench_.document.empty());
    panel_->setSceneThere(live && !bench_.document.empty());
    for (const char* id : {"study-replace", "study-show", "study-remove"})
        bench_.actions[id].setEnabled(live && chosen);
    bench_.actions["study-save"].setEnabled(!desk_->study().conditions.empty());
    bench_.actions["study-run"].setEnabled(live && check(desk_->study().design).has_value());
}

/// Goes on where nothing would be lost by it; else says what would be, with a way to do so.
void StudyController::leave(std::function<void()> goOn) {
    if (!desk_->modified()) return goOn();
    bench_.notice.offer(tr("The study has not been saved. Study > Save the study as... keeps it."),
                        QStringLiteral("note"), tr("Go on without it"), [this, goOn = std::move(goOn)] {
                            desk_->begin();
                            goOn();
                        });
}

void StudyController::askForFile() {
    const QString file = QFileDialog::getOpenFileName(&bench_.window, tr("Open a study"), desk_->file(),
                                                      tr("Studies (*.%1)").arg(studyEnding()));
    if (!file.isEmpty()) desk_->open(file);
}

void StudyController::save(std::function<void()> after) {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    const QString now =
        desk_->file().isEmpty() ? folder + QStringLiteral("/study.") + studyEnding() : desk_->file();
    const QString file =
        askWhere(&bench_.window, tr("Save the study"), {{tr("Studies"), studyEnding()}}, now);
    if (file.isEmpty()) return;
    desk_->save(file, [this, file, after = std::move(after)] {
        bench_.notice.showNote(tr("The study was saved to %1.").arg(file));
        if (after) after();
    });
}

void StudyController::keepState() {
    const int count = int(desk_->study().conditions.size());
    bool agreed = false;
    const QString name =
        QInputDialog::getText(&bench_.window, tr("Keep this state"), tr("Name of the condition"),
                              QLineEdit::Normal, tr("State %1").arg(count + 1), &agreed);
    if (agreed && !desk_->keep(name))
        bench_.notice.showError(
            tr("A condition needs a name of its own, and there may be %1 of them.").arg(kMaxConditions));
    else if (agreed)
        bench_.notice.showNote(tr("Kept as a condition of the study: %1").arg(name.trimmed()));
    bench_.dock("dock-study").raise();
}

void StudyController::edit() {
    const Study& study = desk_->study();
    if (const auto design = askForDesign(&bench_.window, study.design, study.conditions))
        desk_->setDesign(*design);
}

/// As it is saved: the logs name the file by its fingerprint.
void StudyController::askToRun() {
    const auto ask = [this] {
        const auto start = askForStart(&bench_.window, desk_->study().design, desk_->file());
        if (start) begin(*start);
    };
    if (desk_->file().isEmpty()) return save(ask);
    if (!desk_->modified()) return ask();
    desk_->save(desk_->file(), ask);
}

void StudyController::begin(const StudyStart& start) {
    bench_.playback.end();
    emit begins();
    arming_.switchOff();
    const auto study = std::make_shared<const Study>(desk_->study());
    if (const auto begun = study_->begin(study, start); !begun)
        return bench_.notice.showError(QString::fromStdString(begun.error().text));
    hideAll();
    bench_.view.setTouched({});
    stage_.showOther(study->conditions[0]); // whatever is felt: what is seen tells nothing
    hand_.placeBeside();
}

/// All that tells what is felt, and all that could change it.
void StudyController::hideAll() {
    bench_.actions["touch"].trigger();
    for (const Command& command : commands())
        if (QAction& action = bench_.actions[command.id]; action.isEnabled()) {
            action.setEnabled(false);
            off_.push_back(&action);
        }
    QAction& panels = bench_.actions["panels"];
    hidPanels_ = !panels.isChecked();
    panels.setChecked(true);
    QMainWindow& window = bench_.window;
    for (QWidget* each :
         {static_cast<QWidget*>(window.menuBar()),
          static_cast<QWidget*>(window.findChild<QToolBar*>(QStringLiteral("tools"))),
          static_cast<QWidget*>(window.findChild<QToolBar*>(QStringLiteral("forces"))),
          static_cast<QWidget*>(window.statusBar()), static_cast<QWidget*>(window.findChild<ImportBar*>())})
        if (each->isVisible()) {
            each->hide();
            hid_.push_back(each);
        }
    bench_.notice.hide();
    title_ = window.windowTitle();
    window.setWindowTitle(QStringLiteral("Tactum[*]"));
    window.setAcceptDrops(false);
    bench_.view.setFocusPolicy(Qt::NoFocus); // keys are the page's
    bench_.view.setOverlayVisible(study_->run().design().view == StudyView::Shown);
    FeltOptions nothing;
    nothing.normals = nothing.planes = false;
    bench_.view.setFelt(nothing);
    bench_.view.clearTrail();
    page_.raise();
    window.activateWindow(); // after the dialog
    page_.setFocus();
}

void StudyController::showAll() {
    for (QAction* action : std::exchange(off_, {}))
        action->setEnabled(true);
    for (QWidget* each : std::exchange(hid_, {}))
        each->show();
    if (std::exchange(hidPanels_, false)) bench_.actions["panels"].setChecked(false);
    bench_.window.setWindowTitle(title_);
    bench_.window.setAcceptDrops(true);
    bench_.view.setFocusPolicy(Qt::StrongFocus);
    bench_.view.setOverlayVisible(bench_.actions["overlay"].isChecked());
    page_.hide();
    bench_.view.setFocus();
}

/// Safe to call when the run has ended by itself. Forces off: the finger may be inside of the author's model.
void StudyController::end() {
    study_->end();
    if (page_.isHidden()) return;
    arming_.switchOff();
    showAll();
    stage_.showOwn();
    hand_.placeBeside();
    showCommands();
    emit ended();
    bench_.notice.showNote(tr("The answers are in %1, the touch beside them. The forces are off.")
                               .arg(QString::fromStdU16String(study_->answers().u16string())));
}

void StudyController::arm() {
    arming_.switchOn();
    bench_.actions["stop"].setEnabled(false); // as all commands
}

void StudyController::proceed() {
    if (!study_->running() || study_->run().step() == StudyStep::Done) return end();
    if (study_->run().step() == StudyStep::Instructions) arm();
    study_->proceed();
}

void StudyController::showStep() {
    if (study_->running()) page_.display(study_->run(), momentOf(*study_, bench_.engine));
}

void StudyController::frame() {
    hand_.follow();
    trace_.clear();
    for (TracePoint point; bench_.engine.popTrace(point);)
        trace_.push_back(point);
    study_->take(trace_);
    if (!study_->running()) return;
    const StudyStep step = study_->run().step();
    const bool moves =
        step == StudyStep::Stimulus || step == StudyStep::Pause; // a question keeps what is typed
    if (moves && page_.moment() != momentOf(*study_, bench_.engine)) showStep();
    if (study_->run().design().view == StudyView::Shown && bench_.view.isVisible())
        showBlind(bench_.view, bench_.engine);
}

} // namespace tactum
