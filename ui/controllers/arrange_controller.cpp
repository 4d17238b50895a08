#include "ui/controllers/arrange_controller.h"

#include <QActionGroup>

#include "core/runtime/engine.h"
#include "core/scene/order.h"
#include "ui/document/document.h"
#include "ui/showing/playback.h"
#include "ui/tools/arrange_tool.h"
#include "ui/widgets/notice_bar.h"
#include "ui/widgets/tool_strip.h"

namespace tactum {

namespace {

constexpr std::pair<const char*, Pivot> kPivots[] = {{"pivot-middle", Pivot::Middle},
                                                     {"pivot-each", Pivot::Each},
                                                     {"pivot-last", Pivot::Last},
                                                     {"pivot-world", Pivot::World}};
struct LineCommand {
    const char* id;
    int axis;
    BoxSide side;
};
constexpr LineCommand kLines[] = {
    {"align-x-low", 0, BoxSide::Low},       {"align-x-middle", 0, BoxSide::Middle},
    {"align-x-high", 0, BoxSide::High},     {"align-y-low", 1, BoxSide::Low},
    {"align-y-middle", 1, BoxSide::Middle}, {"align-y-high", 1, BoxSide::High},
    {"align-z-low", 2, BoxSide::Low},       {"align-z-middle", 2, BoxSide::Middle},
    {"align-z-high", 2, BoxSide::High}};
constexpr std::pair<const char*, int> kDistances[] = {
    {"distribute-x", 0}, {"distribute-y", 1}, {"distribute-z", 2}};
constexpr std::pair<const char*, bool> kHandleAxes[] = {{"axes-world", false}, {"axes-own", true}};

} // namespace

ArrangeController::ArrangeController(const Workbench& bench, ArrangeTool& arranging, ToolStrip& strip)
    : QObject(&bench.window), bench_(bench), arranging_(arranging) {
    connectChoices();
    connectLines();
    connect(&bench.actions["arrange"], &QAction::toggled, this, [this, &strip](bool on) {
        arranging_.setActive(on && !bench_.playback.active());
        strip.setVisible(on);
    });
    connect(&arranging, &ArrangeTool::refused, &bench.notice, &NoticeBar::showNote);
    // What is arranged is where it begins: it goes there, and stays until time goes on again.
    connect(&arranging, &ArrangeTool::begun, this, [this] {
        bench_.actions["motion-run"].setChecked(false);
        bench_.engine.beginBodies();
    });
    fill(strip);
}

void ArrangeController::connectChoices() {
    const auto choices = [this](const auto& rows, auto choose) {
        auto* group = new QActionGroup(this);
        for (const auto& [id, value] : rows) {
            group->addAction(&bench_.actions[id]);
            bench_.on(id, this, [choose, value = value] { choose(value); });
        }
        group->actions().front()->setChecked(true);
    };
    choices(kPivots, [this](Pivot pivot) { arranging_.setPivot(pivot); });
    choices(kHandleAxes, [this](bool own) { arranging_.setOwnAxes(own); });
}

void ArrangeController::connectLines() {
    for (const auto& [id, axis, side] : kLines)
        bench_.on(id, this, [this, axis = axis, side = side] { arranging_.alignWithActive(axis, side); });
    for (const auto& [id, axis] : kDistances)
        bench_.on(id, this, [this, axis = axis] { arranging_.distributeEvenly(axis); });
    for (const auto& [id, move] : {std::pair{"object-up", &moveUp}, {"object-down", &moveDown}})
        bench_.on(id, this, [this, move = move] {
            const std::vector<ObjectId> chosen = bench_.document.selectedObjects();
            if (chosen.empty()) return bench_.notice.showNote(arranging_.whyNot());
            bench_.document.editOrder(tr("Another order"), [&](Scene& scene) { move(scene, chosen); });
        });
}

void ArrangeController::fill(ToolStrip& strip) {
    strip.setObjectName(QStringLiteral("arrange-strip"));
    strip.hide();
    QList<QAction*> pivots, axes;
    for (const auto& [id, pivot] : kPivots)
        pivots << &bench_.actions[id];
    for (const auto& [id, own] : kHandleAxes)
        axes << &bench_.actions[id];
    strip.addLabel(tr("Turns about"));
    strip.addChoices(tr("About what objects turn and scale"), pivots,
                     {tr("Middle of all"), tr("Each its own"), tr("The last one"), tr("Origin")});
    strip.addLabel(tr("Handles along"));
    strip.addChoices(tr("Axes of the handles"), axes, {tr("The world"), tr("The object")});
    strip.addGap();
    strip.addLabel(tr("Ctrl snaps, Shift is fine, Esc gives up"));
}

} // namespace tactum
