#include "ui/view/hand_tool.h"

#include <algorithm>

namespace tactum {

namespace {

// Parts of the scene's diagonal: for a model of 0.2 m, one millimetre.
constexpr double kNotch = 0.005, kStep = 0.005;
constexpr double kHoverHeight = 0.05;
constexpr double kGlideSpeed = 4;                            ///< diagonals a second
constexpr double kShortestGlide = 0.12, kLongestGlide = 0.6; ///< s

double eased(double part) {
    return part * part * (3 - 2 * part);
}

} // namespace

void HandTool::setGoal(const Vec3& p_W) {
    gliding_ = false;
    goal_ = p_W;
}

void HandTool::beginStroke(QPointF cursor, const Vec3& touched_W, const ViewCamera& camera, const Bounds& box,
                           const IsFree& isFree) {
    grip_ = Grip::Stroke;
    cursor_ = cursor;
    pressDepth_ = kPressDepth;
    const Vec3 away = (touched_W - camera.eye()).normalized();
    const Vec3 hover = touched_W - kHoverHeight * sceneSize_ * away;
    glide_ = planGlide(goal_, hover, touched_W + pressDepth() * away, box, isFree);
    glideTime_ = 0;
    glideDuration_ = std::clamp(glide_.length() / (kGlideSpeed * sceneSize_), kShortestGlide, kLongestGlide);
    gliding_ = true;
}

void HandTool::beginMove(Grip grip, QPointF cursor) {
    gliding_ = false;
    grip_ = grip;
    cursor_ = cursor;
}

// A glide goes on: a mere click brings the finger all the way.
void HandTool::end() {
    grip_ = Grip::None;
}

void HandTool::moveTo(QPointF cursor, const ViewCamera& camera, const std::optional<Vec3>& touched_W,
                      bool alongView) {
    const QPointF step = cursor - cursor_;
    cursor_ = cursor;
    if (alongView)
        shift(-camera.pixelSize(goal_) * step.y(), camera);
    else if (grip_ != Grip::Stroke)
        goal_ += camera.dragVector(goal_, step);
    else if (touched_W)
        setTarget(*touched_W + pressDepth() * (*touched_W - camera.eye()).normalized());
    else
        setTarget(camera.pointAtDepthOf(goal_, cursor));
}

void HandTool::setTarget(const Vec3& target) {
    if (gliding_)
        glide_.moveEnd(target);
    else
        goal_ = target;
}

void HandTool::push(double notches, const ViewCamera& camera) {
    shift(kNotch * sceneSize_ * notches, camera);
}

/// Away from the eye by metres; a stroke goes on at the new depth.
void HandTool::shift(double metres, const ViewCamera& camera) {
    if (grip_ == Grip::Stroke) pressDepth_ += metres / sceneSize_;
    const Vec3 target = gliding_ ? glide_.points().back() : goal_;
    setTarget(target + metres * (target - camera.eye()).normalized());
}

void HandTool::nudge(const Vec3& steps, const ViewCamera& camera) {
    gliding_ = false;
    goal_ += kStep * sceneSize_ *
             (steps.x() * camera.right() + steps.y() * camera.up() + steps.z() * camera.forward());
}

bool HandTool::advance(double seconds) {
    if (!gliding_) return false;
    glideTime_ += seconds;
    goal_ = glide_.at(eased(std::min(1.0, glideTime_ / glideDuration_)));
    gliding_ = glideTime_ < glideDuration_;
    return true;
}

} // namespace tactum
