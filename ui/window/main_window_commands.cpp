// The commands of the window: menus, tool bar, and what each command does.
#include "ui/window/main_window.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QShortcut>
#include <QToolBar>
#include <QToolButton>

#include "core/recording/recording_file.h"
#include "ui/base/ask_where.h"
#include "ui/base/mnemonics.h"
#include "ui/base/style.h"
#include "ui/controllers/folds.h"
#include "ui/controllers/parts_controller.h"
#include "ui/controllers/select_controller.h"
#include "ui/controllers/selection_sets_menu.h"
#include "ui/document/recent_files.h"
#include "ui/engine/held_key.h"
#include "ui/engine/touched.h"
#include "ui/panels/body_panel.h"
#include "ui/panels/start_page.h"
#include "ui/panels/status_strip.h"
#include "ui/showing/playback.h"
#include "ui/tools/arrange_tool.h"
#include "ui/tools/hand_link.h"
#include "ui/tools/touch_hint.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"
#include "ui/widgets/tool_strip.h"
#include "ui/window/guide_window.h"
#include "ui/window/keyboard_sheet.h"

namespace tactum {

namespace {

constexpr double kTurn = 0.2617993877991494, kNearer = 0.8; // 15 degrees

QString readableFilter() {
    QStringList patterns;
    for (const std::string& ending : readableEndings())
        patterns << QStringLiteral("*.") + QString::fromStdString(ending);
    const QString models = patterns.join(u' ');
    const QString recordings = QStringLiteral("*.") + QString::fromStdString(std::string(kRecordingEnding));
    return QObject::tr("Models and recordings (%1 %2);;Models (%1);;Recordings (%2)").arg(models, recordings);
}

void aboutTactum(QWidget* parent) {
    QMessageBox::about(
        parent, QObject::tr("About Tactum"),
        QObject::tr(
            "<h3>Tactum %1</h3><p>Gives the surfaces of 3-D models a feel, and lets you touch them. After "
            "Ruspini and Khatib, <i>Haptic Display for Human Interaction with Virtual Dynamic "
            "Environments</i>, 2001.</p><p>BSD-3-Clause licence.</p>")
            .arg(QCoreApplication::applicationVersion()));
}

} // namespace

/// What has no room goes into a menu at the right end of the first; the second, with the forces, always has.
void MainWindow::makeToolBars() {
    const auto add = [this](const char* name, const QString& title) {
        auto* bar = addToolBar(title);
        bar->setObjectName(QLatin1String(name));
        bar->setMovable(false);
        bar->setIconSize({24, 24});
        return bar;
    };
    QToolBar* tools = add("tools", tr("Tools"));
    for (const char* id : {"open", "", "undo", "redo", "", "touch", "select", "paint", "arrange", "", "fit",
                           "view-front", "view-right", "view-top", "view-isometric", "", "overlay"}) {
        if (*id)
            tools->addAction(&actions_[id]);
        else
            tools->addSeparator();
    }
    QToolBar* forces = add("forces", tr("Forces"));
    forces->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
    forces->addAction(&actions_["armed"]);
    forces->toggleViewAction()->setVisible(false); // among the panels that can be hidden
    for (const char* id : {"open", "touch", "select", "paint", "arrange", "armed"})
        for (QToolBar* bar : {tools, forces})
            if (auto* button = static_cast<QToolButton*>(bar->widgetForAction(&actions_[id])))
                button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    refreshMore();
}

/// The style's own is black on every ground.
void MainWindow::refreshMore() {
    for (auto* more : findChildren<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"))) {
        more->setIcon(icon(QStringLiteral("chevron-right")));
        more->setIconSize({16, 16});
        more->setToolTip(tr("Tools that have no room"));
        more->setAccessibleName(more->toolTip());
    }
}

void MainWindow::makeMenus() {
    actions_.fill(*menuBar());
    auto* file = menuBar()->findChild<QMenu*>(QStringLiteral("File"));
    auto* recent = new QMenu(tr("Ope&n recent"), file);
    file->insertMenu(&actions_["save-picture"], recent);
    connect(recent, &QMenu::aboutToShow, this, [this, recent] { fillRecent(recent); });
    auto* samples = new QMenu(tr("From the sam&ples"), file);
    menuBar()->findChild<QMenu*>(QStringLiteral("File/A&dd"))->addMenu(samples);
    parts_->fillSamples(*samples);
    auto* view = menuBar()->findChild<QMenu*>(QStringLiteral("View"));
    QMenu* panels = createPopupMenu();
    panels->setTitle(tr("&Panels"));
    connect(panels, &QMenu::aboutToShow, panels, [panels] { giveMnemonics(*panels); });
    view->addMenu(panels);
}

void MainWindow::fillRecent(QMenu* menu) {
    menu->clear();
    const QStringList files = recentFiles();
    for (const QString& file : files)
        menu->addAction(QFileInfo(file).fileName().replace(u'&', QStringLiteral("&&")), this,
                        [this, file] { open(file); })
            ->setToolTip(file);
    if (files.isEmpty())
        menu->addAction(tr("No file was opened yet"))->setEnabled(false);
    else
        menu->addSeparator();
    if (!files.isEmpty())
        menu->addAction(tr("Forget them"), this, [this] {
            forgetRecentFiles();
            emit save_->filesChanged();
        });
    giveMnemonics(*menu);
}

void MainWindow::connectFile() {
    connect(&actions_["open"], &QAction::triggered, this, &MainWindow::askForFile);
    connect(&actions_["connect"], &QAction::triggered, this, &MainWindow::connectToServer);
    connect(&actions_["save-picture"], &QAction::triggered, this, &MainWindow::savePicture);
    connect(&actions_["restart-proxy"], &QAction::triggered, this, [this] { engine_.restartProxy(); });
    connect(&actions_["quit"], &QAction::triggered, this, &QWidget::close);
    connect(&actions_["guide"], &QAction::triggered, this, [this] { showGuide(this); });
    connect(&actions_["keyboard"], &QAction::triggered, this, [this] { showKeyboardSheet(this); });
    connect(&actions_["about"], &QAction::triggered, this, [this] { aboutTactum(this); });
    connect(start_, &StartPage::openRequested, this, &MainWindow::askForFile);
    connect(start_, &StartPage::fileChosen, this, &MainWindow::open);
}

void MainWindow::connectEdit() {
    QUndoStack& history = document_.history();
    QAction &undo = actions_["undo"], &redo = actions_["redo"];
    undo.setEnabled(false);
    redo.setEnabled(false);
    connect(&undo, &QAction::triggered, &history, &QUndoStack::undo);
    connect(&redo, &QAction::triggered, &history, &QUndoStack::redo);
    connect(&history, &QUndoStack::canUndoChanged, &undo, &QAction::setEnabled);
    connect(&history, &QUndoStack::canRedoChanged, &redo, &QAction::setEnabled);
    connect(&history, &QUndoStack::undoTextChanged, &undo,
            [&undo](const QString& text) { undo.setText(tr("&Undo %1").arg(text)); });
    connect(&history, &QUndoStack::redoTextChanged, &redo,
            [&redo](const QString& text) { redo.setText(tr("&Redo %1").arg(text)); });
    connect(&actions_["show-all"], &QAction::triggered, &document_, &Document::showAll);
    connect(&actions_["hide"], &QAction::triggered, this,
            [this] { document_.setSurfacesVisible(document_.selected(), false); });
    connect(&actions_["isolate"], &QAction::triggered, this, [this] {
        if (document_.selection()) document_.isolate(document_.selected());
    });
    connect(&actions_["lock"], &QAction::triggered, this, [this] {
        const auto active = document_.selection();
        if (active) document_.setLocked(document_.selected(), !document_.surface(*active)->locked);
    });
}

void MainWindow::connectView() {
    auto* tools = new QActionGroup(this);
    for (const char* id : {"touch", "select", "paint", "arrange", "measure"})
        tools->addAction(&actions_[id]);
    connect(&actions_["touch"], &QAction::triggered, this, [this] { view_->setTool(ViewTool::Touch); });
    connect(&actions_["select"], &QAction::triggered, this, [this] { view_->setTool(ViewTool::Select); });
    connect(&actions_["paint"], &QAction::triggered, this, [this] { view_->setTool(ViewTool::Paint); });
    connect(&actions_["arrange"], &QAction::triggered, this, [this] { view_->setTool(ViewTool::Arrange); });
    connect(&actions_["measure"], &QAction::triggered, this, [this] { view_->setTool(ViewTool::Measure); });
    connect(&actions_["select"], &QAction::toggled, selectStrip_, &QWidget::setVisible);
    connect(&actions_["touch"], &QAction::toggled, this, &MainWindow::offerHint);
    actions_["touch"].trigger();
    connect(&actions_["fit"], &QAction::triggered, view_, &SceneView::fit);
    const std::pair<const char*, StandardView> views[] = {{"view-front", StandardView::Front},
                                                          {"view-right", StandardView::Right},
                                                          {"view-top", StandardView::Top},
                                                          {"view-isometric", StandardView::Isometric}};
    for (const auto& [id, standard] : views)
        connect(&actions_[id], &QAction::triggered, this,
                [this, standard = standard] { view_->showStandardView(standard); });
    struct CameraCommand {
        const char* id;
        double yaw, pitch, nearer;
    };
    for (const CameraCommand& each : {CameraCommand{"orbit-left", -kTurn, 0, 1},
                                      {"orbit-right", kTurn, 0, 1},
                                      {"orbit-up", 0, kTurn, 1},
                                      {"orbit-down", 0, -kTurn, 1},
                                      {"zoom-in", 0, 0, kNearer},
                                      {"zoom-out", 0, 0, 1 / kNearer}})
        connect(&actions_[each.id], &QAction::triggered, this,
                [this, each] { view_->moveCamera(each.yaw, each.pitch, each.nearer); });
    connect(&actions_["overlay"], &QAction::toggled, view_, &SceneView::setOverlayVisible);
    actions_["overlay"].setChecked(true);
    connect(view_, &SceneView::handGrabbed, this, [this](bool grabbed) {
        if (grabbed) hint_->followed();
    });
}

void MainWindow::connectSelecting() {
    sets_ = new SelectionSetsMenu(bench_, *menuBar()->findChild<QMenu*>(QStringLiteral("Select")));
    selecting_ = new SelectController(bench_, *selectStrip_, *sets_);
    connect(&actions_["select-touched"], &QAction::triggered, this, &MainWindow::selectTouched);
    connect(view_, &SceneView::picked, this, &MainWindow::pick);
    // Told by the view when it is another one; a value may be changed while the mouse stays.
    connect(view_, &SceneView::surfaceHovered, this, [this](const std::optional<SurfaceRef>& surface) {
        hovered_ = playback_->active() ? std::nullopt : surface;
        showHovered();
    });
    connect(&document_, &Document::changed, this, &MainWindow::showHovered);
}

void MainWindow::pick(const std::optional<PickHit>& hit, Qt::KeyboardModifiers modifiers) {
    if (playback_->active()) return; // a recording shows surfaces of another scene
    if (hit && docks_.body->picksPath()) return docks_.body->addPathPoint(hit->point);
    if (actions_["select"].isChecked()) return selecting_->take(hit, modifiers);
    if (actions_["arrange"].isChecked()) return arranging_->choose(hit, modifiers);
    if (actions_["paint"].isChecked()) return; // beside the model: what is selected stays to be painted
    document_.select(hit ? std::optional(hit->surface) : std::nullopt);
}

void MainWindow::showHovered() {
    status_->setHovered(hovered_ ? feelText(document_.scene(), *hovered_) : QString());
}

void MainWindow::connectDocument() {
    connect(&document_, &Document::changed, this, &MainWindow::follow);
    connect(&document_, &Document::opened, this, &MainWindow::showOpened);
    connect(&document_, &Document::added, this, &MainWindow::offerHint);
    connect(&document_, &Document::openFailed, notice_, &NoticeBar::showError);
    connect(&document_, &Document::editProgressed, this, [this](double fraction, double secondsLeft) {
        notice_->showProgress(tr("Changing the mesh"), fraction, secondsLeft, true);
    });
    connect(&document_, &Document::editEnded, this, [this](const QString& sentence) {
        notice_->endProgress();
        if (!sentence.isEmpty()) notice_->showError(sentence);
    });
    connect(notice_, &NoticeBar::cancelled, &document_, &Document::cancelEdit);
    connect(&document_, &Document::openProgressed, this, [this](double fraction, double secondsLeft) {
        notice_->showProgress(document_.adding() ? tr("Adding") : tr("Opening"), fraction, secondsLeft, true);
    });
    connect(notice_, &NoticeBar::cancelled, &document_, &Document::cancelOpen);
    connect(&publisher_, &WorldPublisher::progressed, this, [this](double fraction, double secondsLeft) {
        if (!document_.opening())
            notice_->showProgress(tr("Preparing the surfaces for touch"), fraction, secondsLeft, false);
    });
    connect(&publisher_, &WorldPublisher::shapesPublished, notice_, &NoticeBar::endProgress);
    connect(&publisher_, &WorldPublisher::failed, this, [this](const QString& sentence) {
        notice_->endProgress();
        notice_->showError(tr("What you touch is still as it was before: %1").arg(sentence));
    });
}

void MainWindow::askForFile() {
    const QString file = QFileDialog::getOpenFileName(this, tr("Open a model or a recording"),
                                                      recentFiles().value(0), readableFilter());
    if (!file.isEmpty()) open(file);
}

void MainWindow::savePicture() {
    const QImage picture =
        view_->grabWithoutHandles(); // as it is now, however long the person looks for a place
    const QString file = askWhere(this, tr("Save the view"), {{tr("Pictures"), QStringLiteral("png")}},
                                  QStringLiteral("touch.png"));
    if (file.isEmpty()) return;
    if (picture.save(file, "PNG"))
        notice_->showNote(tr("The view was written to %1.").arg(file));
    else
        notice_->showError(
            tr("%1 cannot be written. Choose another folder, or make room on the disk.").arg(file));
}

} // namespace tactum
