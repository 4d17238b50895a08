#include "ui/tools/hand_link.h"

#include "ui/view/scene_view.h"

namespace tactum {

namespace {
constexpr std::uint64_t kArrival = 50; // servo ticks, of which the jump takes one
constexpr double kWithin = 0.95;       // of the workspace: at its wall it could not go on
} // namespace

HandLink::HandLink(SceneView& view, Engine& engine, std::shared_ptr<HandTarget> target, QObject* parent)
    : QObject(parent), view_(view), hands_(engine), target_(std::move(target)) {
    connect(&view_, &SceneView::handGoalMoved, this, [this](const Vec3& goal_W, double time) {
        if (suspended_) return;
        goal_.position = goal_W;
        goal_.time = time;
        send();
    });
    connect(&view_, &SceneView::handGrabbed, this, [this](bool grabbed) {
        goal_.held = grabbed;
        send();
    });
}

void HandLink::placeBeside() {
    if (const auto place = view_.placeBeside(kWithin * hands_.device(led_).workspaceRadius)) placeAt(*place);
}

/// Their fingers are where they are.
void HandLink::restartOthers() {
    for (std::size_t hand = 0; hand < hands_.count(); ++hand)
        if (idle_ || hand != led_) hands_.restartProxy(hand);
}

void HandLink::placeAt(const Vec3& p_W) {
    restartOthers();
    if (idle_) return;
    if (!target_) return;
    goal_.position = p_W;
    // The mark stays on in every later goal with the same number, so that a goal written before the hand has
    // read this one does not swallow the jump.
    goal_.teleport = true;
    ++goal_.sequence;
    arrival_ = hands_.servo(led_).ticks + kArrival;
    view_.setHandGoal(goal_.position);
    send();
}

void HandLink::follow() {
    if (idle_) arrival_ = 0;
    if (arrival_ == 0 || hands_.servo(led_).ticks < arrival_) return;
    // Only now: a proxy put onto the finger before the jump would be dragged through the new model.
    arrival_ = 0;
    hands_.restartProxy(led_);
}

void HandLink::send() {
    if (target_ && !idle_) target_->write(goal_);
}

} // namespace tactum
