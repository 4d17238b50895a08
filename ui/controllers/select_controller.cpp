#include "ui/controllers/select_controller.h"

#include <algorithm>
#include <array>

#include <QActionGroup>
#include <QToolButton>

#include "ui/controllers/selection_sets_menu.h"
#include "ui/panels/parameter_field.h"
#include "ui/panels/selection_count.h"
#include "ui/showing/playback.h"
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

constexpr double kLargerBrush = 1.15;

} // namespace

SelectController::SelectController(const Workbench& bench, ToolStrip& strip, SelectionSetsMenu& sets)
    : QObject(&bench.window), bench_(bench), tool_(new SelectTool(bench.document, this)),
      regions_(new RegionSelect(bench.document, bench.view, this)) {
    connectReaches();
    connectCommands();
    connectRegions();
    connectBrush();
    fillStrip(strip, sets);
    showSelection();
}

void SelectController::connectReaches() {
    auto* reaches = new QActionGroup(this);
    for (const ReachCommand& each : kReaches) {
        reaches->addAction(&bench_.actions[each.id]);
        bench_.on(each.id, this, [this, reach = each.reach] {
            tool_->setReach(reach);
            regions_->setTakesSurfaces(takesSurfaces(reach));
            bench_.actions["select"].trigger();
        });
    }
    bench_.actions["take-surface"].setChecked(true);
}

void SelectController::connectCommands() {
    const std::pair<const char*, void (SelectTool::*)()> simple[] = {
        {"select-all", &SelectTool::takeAll},
        {"select-none", &SelectTool::takeNothing},
        {"select-like", &SelectTool::takeLikeActive},
        {"select-colour", &SelectTool::takeColourOfActive},
        {"grow", &SelectTool::grow},
        {"shrink", &SelectTool::shrink},
        {"invert", &SelectTool::invert}};
    for (const auto& [id, command] : simple)
        connect(&bench_.actions[id], &QAction::triggered, tool_, command);
    bench_.on("split", this, [this] { bench_.document.splitSelection(); });
    bench_.on("merge", this, [this] { bench_.document.mergeSelected(); });
    connect(tool_, &SelectTool::progressed, this, [this](double fraction, double secondsLeft) {
        bench_.notice.showProgress(tr("Finding the neighbours of every triangle"), fraction, secondsLeft,
                                   false);
    });
    connect(tool_, &SelectTool::finished, &bench_.notice, &NoticeBar::endProgress);
}

void SelectController::take(const std::optional<PickHit>& hit, Qt::KeyboardModifiers modifiers) {
    tool_->take(hit, modifiers);
}

void SelectController::connectRegions() {
    for (const auto& [id, shape] :
         {std::pair("box", RegionShape::Box), std::pair("lasso", RegionShape::Lasso)})
        bench_.on(id, this, [this, shape = shape] {
            bench_.actions["select"].trigger();
            bench_.view.beginRegion(shape);
        });
    bench_.actions["through"].setChecked(true);
    connect(&bench_.actions["through"], &QAction::toggled, regions_, &RegionSelect::setThrough);
    // A recording shows surfaces of another scene.
    connect(&bench_.view, &SceneView::boxDrawn, this, [this](const QRectF& box, auto modifiers) {
        if (!bench_.playback.active()) regions_->takeBox(box, selectModeOf(modifiers));
    });
    connect(&bench_.view, &SceneView::lassoDrawn, this, [this](const QPolygonF& line, auto modifiers) {
        if (!bench_.playback.active()) regions_->takeLasso(line, selectModeOf(modifiers));
    });
    connect(&bench_.view, &SceneView::selectBrushed, this,
            [this](StrokeStep step, QPointF from, QPointF to, auto modifiers) {
                if (!bench_.playback.active()) regions_->brush(step, from, to, selectModeOf(modifiers));
            });
    connect(regions_, &RegionSelect::progressed, this, [this](double fraction, double secondsLeft) {
        bench_.notice.showProgress(tr("Looking which triangles lie there"), fraction, secondsLeft, false);
    });
    connect(regions_, &RegionSelect::finished, &bench_.notice, &NoticeBar::endProgress);
}

void SelectController::connectBrush() {
    QAction &brush = bench_.actions["select-brush"], &select = bench_.actions["select"];
    const auto showBrush = [this, &brush] {
        bench_.view.setSelectBrush(brush.isChecked() ? std::optional(regions_->brushRadius()) : std::nullopt);
    };
    connect(&brush, &QAction::toggled, this, [&select, showBrush](bool on) {
        if (on) select.trigger();
        showBrush();
    });
    connect(&bench_.view, &SceneView::selectBrushLeft, &brush, [&brush] { brush.setChecked(false); });
    connect(&select, &QAction::toggled, &brush, [&brush](bool on) {
        if (!on) brush.setChecked(false);
    });
    for (const auto& [id, factor] :
         {std::pair("brush-bigger", kLargerBrush), std::pair("brush-smaller", 1 / kLargerBrush)})
        bench_.on(id, this, [this, &select, showBrush, factor = factor] {
            if (!select.isChecked()) return;
            regions_->scaleBrush(factor);
            showBrush();
        });
}

void SelectController::fillStrip(ToolStrip& strip, SelectionSetsMenu& sets) {
    QList<QAction*> actions;
    QStringList names;
    for (const ReachCommand& each : kReaches) {
        actions << &bench_.actions[each.id];
        names << tr(each.name);
    }
    strip.addLabel(tr("A click takes"));
    strip.addChoices(tr("A click takes"), actions, names);
    addAngle(strip, actions);
    for (const char* id : {"box", "lasso", "select-brush"})
        strip.addAction(&bench_.actions[id]);
    strip.addAction(&bench_.actions["through"], tr("Through"));
    strip.addField(sets.makeButton());
    strip.addField(new SelectionCount(bench_.document));
    strip.addGap();
    QList<QAction*> changes;
    for (const char* id : {"split", "merge", "invert", "grow", "shrink"})
        changes << &bench_.actions[id];
    strip.addMenu(tr("Change"), tr("What can be done with what is selected"), changes);
}

void SelectController::addAngle(ToolStrip& strip, const QList<QAction*>& reaches) {
    auto* angle = new ParameterField(kSelectAngle);
    angle->setMaximumWidth(200);
    connect(angle, &ParameterField::edited, this, [this, angle](double value) {
        tool_->setAngle(value);
        angle->setValue(value);
    });
    const auto showAngle = [angle, this] {
        angle->setVisible(
            std::ranges::any_of(std::array{"take-smooth", "take-similar", "take-facing"},
                                [this](const char* id) { return bench_.actions[id].isChecked(); }));
    };
    for (QAction* action : reaches)
        connect(action, &QAction::toggled, angle, showAngle);
    showAngle();
    strip.addField(angle);
}

void SelectController::showSelection() {
    const FaceSelection& faces = bench_.document.selectedFaces();
    bench_.view.setSelection(bench_.document.selected());
    bench_.view.setSelectedFaces(faces.object, faces.faces);
    for (const char* id : {"grow", "shrink", "split"})
        bench_.actions[id].setEnabled(!faces.empty());
    bench_.actions["merge"].setEnabled(bench_.document.selected().size() > 1);
}

} // namespace tactum
