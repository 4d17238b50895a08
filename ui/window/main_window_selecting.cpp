// Selecting and what is done with a selection: commands, and the row above the view.
#include "ui/window/main_window.h"

#include <algorithm>
#include <array>

#include <QActionGroup>

#include "ui/engine/touched.h"
#include "ui/panels/body_panel.h"
#include "ui/panels/parameter_field.h"
#include "ui/panels/selection_count.h"
#include "ui/panels/status_strip.h"
#include "ui/showing/playback.h"
#include "ui/tools/arrange_tool.h"
#include "ui/tools/region_select.h"
#include "ui/tools/select_tool.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"
#include "ui/widgets/tool_strip.h"

namespace tactum {

namespace {

struct ReachCommand {
    const char* id;
    SelectReach reach;
    const char* name; ///< in the row above the view
};
constexpr ReachCommand kReaches[] = {{"take-surface", SelectReach::Surface, QT_TR_NOOP("Surface")},
                                     {"take-material", SelectReach::Material, QT_TR_NOOP("Same feel")},
                                     {"take-colour", SelectReach::Colour, QT_TR_NOOP("Same colour")},
                                     {"take-connected", SelectReach::Connected, QT_TR_NOOP("Connected")},
                                     {"take-smooth", SelectReach::Smooth, QT_TR_NOOP("Smooth part")},
                                     {"take-similar", SelectReach::Similar, QT_TR_NOOP("Similar normals")},
                                     {"take-facing", SelectReach::Facing, QT_TR_NOOP("Facing the same way")},
                                     {"take-triangle", SelectReach::Triangle, QT_TR_NOOP("Triangle")}};

} // namespace

void MainWindow::connectSelecting() {
    auto* reaches = new QActionGroup(this);
    for (const ReachCommand& each : kReaches) {
        QAction& action = actions_[each.id];
        reaches->addAction(&action);
        connect(&action, &QAction::triggered, this, [this, reach = each.reach] {
            selecting_->setReach(reach);
            regions_->setTakesSurfaces(takesSurfaces(reach));
            actions_["select"].trigger();
        });
    }
    actions_["take-surface"].setChecked(true);
    const std::pair<const char*, void (SelectTool::*)()> simple[] = {
        {"select-all", &SelectTool::takeAll},
        {"select-none", &SelectTool::takeNothing},
        {"select-like", &SelectTool::takeLikeActive},
        {"select-colour", &SelectTool::takeColourOfActive},
        {"grow", &SelectTool::grow},
        {"shrink", &SelectTool::shrink},
        {"invert", &SelectTool::invert}};
    for (const auto& [id, command] : simple)
        connect(&actions_[id], &QAction::triggered, selecting_, command);
    connect(&actions_["select-touched"], &QAction::triggered, this, &MainWindow::selectTouched);
    connect(&actions_["split"], &QAction::triggered, &document_, &Document::splitSelection);
    connect(&actions_["merge"], &QAction::triggered, &document_, &Document::mergeSelected);
    // A recording shows surfaces of another scene.
    connect(view_, &SceneView::picked, this, [this](const std::optional<PickHit>& hit, auto modifiers) {
        if (playback_->active()) return;
        if (hit && docks_.body->picksPath()) return docks_.body->addPathPoint(hit->point);
        if (actions_["select"].isChecked()) return selecting_->take(hit, modifiers);
        if (actions_["arrange"].isChecked()) return arranging_->choose(hit, modifiers);
        if (actions_["paint"].isChecked()) return; // beside the model: what is selected stays to be painted
        document_.select(hit ? std::optional(hit->surface) : std::nullopt);
    });
    connect(selecting_, &SelectTool::progressed, this, [this](double fraction, double secondsLeft) {
        notice_->showProgress(tr("Finding the neighbours of every triangle"), fraction, secondsLeft, false);
    });
    connect(selecting_, &SelectTool::finished, notice_, &NoticeBar::endProgress);
    // Told by the view when it is another one; a value may be changed while the mouse stays.
    connect(view_, &SceneView::surfaceHovered, this, [this](const std::optional<SurfaceRef>& surface) {
        hovered_ = playback_->active() ? std::nullopt : surface;
        showHovered();
    });
    connect(&document_, &Document::changed, this, &MainWindow::showHovered);
    connectRegions();
    fillSelectStrip();
    showSelection();
}

void MainWindow::fillSelectStrip() {
    QList<QAction*> actions;
    QStringList names;
    for (const ReachCommand& each : kReaches) {
        actions << &actions_[each.id];
        names << tr(each.name);
    }
    selectStrip_->addLabel(tr("A click takes"));
    selectStrip_->addChoices(tr("A click takes"), actions, names);
    auto* angle = new ParameterField(kSelectAngle);
    angle->setMaximumWidth(200);
    connect(angle, &ParameterField::edited, this, [this, angle](double value) {
        selecting_->setAngle(value);
        angle->setValue(value);
    });
    const auto showAngle = [angle, this] {
        angle->setVisible(std::ranges::any_of(std::array{"take-smooth", "take-similar", "take-facing"},
                                              [this](const char* id) { return actions_[id].isChecked(); }));
    };
    for (QAction* action : actions)
        connect(action, &QAction::toggled, angle, showAngle);
    showAngle();
    selectStrip_->addField(angle);
    for (const char* id : {"box", "lasso", "select-brush"})
        selectStrip_->addAction(&actions_[id]);
    selectStrip_->addAction(&actions_["through"], tr("Through"));
    selectStrip_->addField(new SelectionCount(document_));
    selectStrip_->addStretch();
    // In a narrow window those with the best-known keys are cut off.
    for (const char* id : {"split", "merge", "invert", "grow", "shrink"})
        selectStrip_->addAction(&actions_[id]);
}

void MainWindow::showHovered() {
    status_->setHovered(hovered_ ? feelText(document_.scene(), *hovered_) : QString());
}

void MainWindow::showSelection() {
    const FaceSelection& faces = document_.selectedFaces();
    view_->setSelection(document_.selected());
    view_->setSelectedFaces(faces.object, faces.faces);
    for (const char* id : {"grow", "shrink", "split"})
        actions_[id].setEnabled(!faces.empty());
    actions_["merge"].setEnabled(document_.selected().size() > 1);
}

} // namespace tactum
