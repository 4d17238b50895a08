#include "ui/controllers/motion_controller.h"

#include "core/runtime/engine.h"
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
    connect(&panel_, &BodyPanel::failed, &bench_.notice, &NoticeBar::showError);
    connect(&panel_, &BodyPanel::marked, this, [this] {
        bench_.view.setJoint(panel_.mark());
        bench_.view.setPath(panel_.path());
        bench_.view.setMass(panel_.mass());
    });
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
