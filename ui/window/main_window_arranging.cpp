// Moving, turning and scaling objects: commands, the row above the view, and the dock of numbers.
#include "ui/window/main_window.h"

#include <QActionGroup>
#include <QDockWidget>

#include "ui/panels/place_panel.h"
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

void MainWindow::addPlaceDock() {
    addTabBeside(*this, *findChild<QDockWidget*>(QStringLiteral("dock-body")), QStringLiteral("dock-place"),
                 tr("Place"), new PlacePanel(document_, *arranging_));
}

void MainWindow::connectArranging() {
    const auto choices = [this](const auto& rows, auto choose) {
        auto* group = new QActionGroup(this);
        for (const auto& [id, value] : rows) {
            group->addAction(&actions_[id]);
            connect(&actions_[id], &QAction::triggered, this, [choose, value = value] { choose(value); });
        }
        group->actions().front()->setChecked(true);
    };
    choices(kPivots, [this](Pivot pivot) { arranging_->setPivot(pivot); });
    choices(kHandleAxes, [this](bool own) { arranging_->setOwnAxes(own); });
    for (const auto& [id, axis, side] : kLines)
        connect(&actions_[id], &QAction::triggered, this,
                [this, axis = axis, side = side] { arranging_->alignWithActive(axis, side); });
    for (const auto& [id, axis] : kDistances)
        connect(&actions_[id], &QAction::triggered, this,
                [this, axis = axis] { arranging_->distributeEvenly(axis); });
    for (const auto& [id, move] : {std::pair{"object-up", &moveUp}, {"object-down", &moveDown}})
        connect(&actions_[id], &QAction::triggered, this, [this, move = move] {
            const std::vector<ObjectId> chosen = document_.selectedObjects();
            if (chosen.empty()) return notice_->showNote(arranging_->whyNot());
            document_.editOrder(tr("Another order"), [&](Scene& scene) { move(scene, chosen); });
        });
    connect(&actions_["arrange"], &QAction::toggled, this, [this](bool on) {
        arranging_->setActive(on && !playback_->active());
        arrangeStrip_->setVisible(on);
    });
    connect(arranging_, &ArrangeTool::refused, notice_, &NoticeBar::showNote);
    // What is arranged is where it begins: it goes there, and stays until time goes on again.
    connect(arranging_, &ArrangeTool::begun, this, [this] {
        actions_["motion-run"].setChecked(false);
        engine_.beginBodies();
    });
    fillArrangeStrip();
}

void MainWindow::fillArrangeStrip() {
    arrangeStrip_->setObjectName(QStringLiteral("arrange-strip"));
    arrangeStrip_->hide();
    QList<QAction*> pivots, axes;
    for (const auto& [id, pivot] : kPivots)
        pivots << &actions_[id];
    for (const auto& [id, own] : kHandleAxes)
        axes << &actions_[id];
    arrangeStrip_->addLabel(tr("Turns about"));
    arrangeStrip_->addChoices(tr("About what objects turn and scale"), pivots,
                              {tr("Middle of all"), tr("Each its own"), tr("The last one"), tr("Origin")});
    arrangeStrip_->addLabel(tr("Handles along"));
    arrangeStrip_->addChoices(tr("Axes of the handles"), axes, {tr("The world"), tr("The object")});
    arrangeStrip_->addGap();
    arrangeStrip_->addLabel(tr("Ctrl snaps, Shift is fine, Esc gives up"));
}

} // namespace tactum
