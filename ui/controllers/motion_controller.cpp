#include "ui/controllers/motion_controller.h"

#include <QDockWidget>
#include <QMainWindow>

#include "core/runtime/engine.h"
#include "ui/controllers/docks.h"
#include "ui/controllers/edit_notice.h"
#include "ui/controllers/folds.h"
#include "ui/document/document.h"
#include "ui/panels/body_panel.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

namespace {

constexpr double kSlow = 0.1;

using Hold = BodyPanel::Hold;
constexpr std::pair<const char*, Hold> kHolds[] = {{"body-loose", Hold::Loose},
                                                   {"body-hinge", Hold::Hinge},
                                                   {"body-slider", Hold::Slider},
                                                   {"body-path", Hold::Path},
                                                   {"body-still", Hold::Still}};

} // namespace

MotionController::MotionController(const Workbench& bench, BodyPanel& panel, Folds& folds)
    : QObject(&bench.window), bench_(bench), panel_(panel), folds_(folds) {
    connectTime();
    connectHolds();
    connectHandles();
    connect(&bench.actions["colliders"], &QAction::toggled, this, &MotionController::showColliders);
    connect(&bench.document, &Document::changed, this, [this](const SceneChange& change) {
        if (change.takesTime()) showColliders();
    });
}

void MotionController::connectTime() {
    QAction& run = bench_.actions["motion-run"];
    run.setChecked(true);
    connect(&run, &QAction::toggled, this, &MotionController::setPace);
    connect(&bench_.actions["motion-slow"], &QAction::toggled, this, &MotionController::setPace);
    bench_.on("motion-step", this, [this, &run] {
        run.setChecked(false);
        bench_.engine.stepBodies();
    });
    bench_.on("motion-reset", this, [this] { bench_.engine.beginBodies(); });
}

void MotionController::setPace() {
    const bool runs = bench_.actions["motion-run"].isChecked();
    bench_.engine.setPace(!runs ? 0 : bench_.actions["motion-slow"].isChecked() ? kSlow : 1);
}

void MotionController::connectHolds() {
    for (const auto& [id, hold] : kHolds)
        bench_.on(id, this, [this, chosen = hold] {
            panel_.hold(chosen);
            folds_.bringForward(bench_.dock("dock-body"));
        });
    connect(&panel_, &BodyPanel::freed, this, &MotionController::tellOfTime);
    connect(&panel_, &BodyPanel::failed, &bench_.notice, &NoticeBar::showError);
    connect(&panel_, &BodyPanel::marked, this, &MotionController::showMarks);
    connect(&bench_.dock("dock-body"), &QDockWidget::visibilityChanged, this, &MotionController::showMarks,
            Qt::QueuedConnection); // when the tabs are as they will be
}

/// Of the panel in front: another one may have handles of its own.
void MotionController::showMarks() {
    const bool behind = dockInFrontOf(bench_.window, bench_.dock("dock-body"));
    bench_.view.setJoint(behind ? std::nullopt : panel_.mark());
    bench_.view.setPath(behind ? std::nullopt : panel_.path());
    bench_.view.setMass(behind ? std::nullopt : panel_.mass());
}

/// Time runs while a scene is made, so what has just been let go may be away before its joint is in place.
void MotionController::tellOfTime(const QString& name) {
    QAction& run = bench_.actions["motion-run"];
    if (!run.isChecked()) return;
    const QString sentence = tr("%1 moves from now on, as time runs.").arg(name);
    bench_.notice.offer(sentence, QStringLiteral("note"), tr("Stop it at the start"), [this, &run] {
        run.setChecked(false);
        bench_.engine.beginBodies();
    });
    bench_.told.keep(sentence);
}

/// One drag of a handle is one step of the history.
void MotionController::connectHandles() {
    const auto gesture = std::make_shared<Gesture>(0);
    const auto begin = [this, gesture] { *gesture = bench_.document.beginTrial(); };
    connect(&bench_.view, &SceneView::jointGrabbed, this, begin);
    connect(&bench_.view, &SceneView::jointDragged, this,
            [this, gesture](const JointMark& mark) { panel_.setMark(mark, *gesture); });
    connect(&bench_.view, &SceneView::pathGrabbed, this, begin);
    connect(&bench_.view, &SceneView::pathDragged, this,
            [this, gesture](const std::vector<Vec3>& points) { panel_.setPath(points, *gesture); });
    connect(&bench_.view, &SceneView::handlesLeft, this,
            [this, gesture](bool givenUp) { bench_.document.endTrial(*gesture, givenUp); });
}

void MotionController::showColliders() {
    bench_.view.setColliders(bench_.actions["colliders"].isChecked() ? colliderMarks(bench_.document.scene())
                                                                     : std::vector<ColliderMark>());
}

} // namespace tactum
