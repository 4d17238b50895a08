#include "ui/view/hand_tool.h"

#include <algorithm>

#include "core/port/minimum_jerk.h"

namespace tactum {

namespace {

// Parts of the scene's diagonal: for a model of 0.2 m, one millimetre.
constexpr double kNotch = 0.005, kStep = 0.005;
constexpr double kGlideSpeed = 4;     ///< diagonals a second
constexpr double kLongestGlide = 0.6; ///< s
/// Of a glide, however late the window is: a hand that is led by fewer places would cut the corners.
constexpr double kLongestGlideStep = 0.1; ///< s
/// Hovers: from so near a hand needs no way around anything.
constexpr double kBesides = 4;
constexpr double kApproachSpeed = 2, kFollowSpeed = 4; ///< diagonals a second, at most

double eased(double part) {
    return part * part * (3 - 2 * part);
}

} // namespace

void HandTool::setGoal(const Vec3& p_W) {
    part_ = Part::None;
    off_.reset();
    goal_ = p_W;
    time_ = 0;
}

void HandTool::beginStroke(QPointF cursor, const Vec3& touched_W, double gap, const ViewCamera& camera,
                           const Bounds& box, const IsFree& isFree) {
    grip_ = Grip::Stroke;
    cursor_ = cursor;
    pressDepth_ = kPressDepth * sceneSize_;
    gap_ = gap;
    setPlaces(touched_W, camera);
    begin(Part::Way, 0);
    if ((goal_ - near_).norm() < kBesides * kHoverHeight * sceneSize_ && isFree(goal_, near_)) return next();
    glide_ = planGlide(goal_, *off_, *off_, box, isFree);
    begin(Part::Way, std::min(glide_.length() / (kGlideSpeed * sceneSize_), kLongestGlide));
}

/// Of a press at a point of the surface. The ray to it is free: that way the hand comes and goes.
void HandTool::setPlaces(const Vec3& touched_W, const ViewCamera& camera) {
    away_ = (touched_W - camera.eye()).normalized();
    near_ = touched_W - gap_ * away_;
    deep_ = touched_W + pressDepth_ * away_;
    off_ = touched_W - std::max(kHoverHeight * sceneSize_, 2 * gap_) * away_;
}

void HandTool::beginMove(Grip grip, QPointF cursor) {
    part_ = Part::None;
    off_.reset();
    grip_ = grip;
    cursor_ = cursor;
}

void HandTool::end() {
    grip_ = Grip::None;
    if (part_ == Part::Way || part_ == Part::Near) deep_ -= (1 - kTapDepth) * pressDepth_ * away_;
    if (!gliding()) begin(Part::Done, 0);
}

/// What hangs in the air stays there.
void HandTool::giveUp() {
    grip_ = Grip::None;
    begin(part_ == Part::Way ? Part::None : Part::Done, 0);
}

void HandTool::lift(const Vec3& to_W) {
    begin(Part::Lift, kLiftTime);
    goal_ = to_W;
    time_ = kLiftTime;
}

void HandTool::begin(Part part, double duration) {
    part_ = part;
    partTime_ = 0;
    partDuration_ = duration;
}

void HandTool::next() {
    if (part_ == Part::Near) {
        begin(Part::Down, kPressTime);
        lead(deep_, kPressTime);
    } else if (part_ == Part::Lift) {
        begin(Part::Up, 0);
    } else if (part_ == Part::Down) {
        begin(grip_ == Grip::None ? Part::Done : Part::None, 0);
    } else {
        const double slow = MinimumJerk::kPeakSpeed * (near_ - goal_).norm() / (kApproachSpeed * sceneSize_);
        begin(Part::Near, std::clamp(slow, kShortestApproach, kLongestApproach));
        lead(near_, partDuration_);
    }
}

/// No faster than a hand does, and no faster than `atLeast`, s.
void HandTool::lead(const Vec3& to, double atLeast) {
    const double slow = MinimumJerk::kPeakSpeed * (to - goal_).norm() / (kFollowSpeed * sceneSize_);
    time_ = std::max(atLeast, slow);
    goal_ = to;
}

void HandTool::moveTo(QPointF cursor, const ViewCamera& camera, const std::optional<Vec3>& touched_W,
                      bool alongView) {
    const QPointF step = cursor - cursor_;
    cursor_ = cursor;
    if (alongView) return shift(-camera.pixelSize(goal_) * step.y(), camera);
    if (grip_ != Grip::Stroke) return lead(goal_ + camera.dragVector(goal_, step));
    if (touched_W) {
        setPlaces(*touched_W, camera);
        followPlaces();
    } else if (!gliding()) { // it has left the model: on, at the depth where it was
        off_.reset();
        lead(camera.pointAtDepthOf(goal_, cursor));
    }
}

/// The place of the press has moved: what is under way goes there in what is left of its time.
void HandTool::followPlaces() {
    const double left = std::max(partDuration_ - partTime_, kFollowTime);
    if (part_ == Part::Way)
        glide_.moveEnd(*off_);
    else if (part_ == Part::Near)
        lead(near_, left);
    else
        lead(deep_, part_ == Part::Down ? left : kFollowTime);
}

void HandTool::push(double notches, const ViewCamera& camera) {
    shift(kNotch * sceneSize_ * notches, camera);
}

/// Away from the eye by metres; a stroke goes on at the new depth.
void HandTool::shift(double metres, const ViewCamera& camera) {
    if (grip_ != Grip::Stroke) {
        if (part_ == Part::Up) part_ = Part::None;
        return lead(goal_ + metres * (goal_ - camera.eye()).normalized());
    }
    pressDepth_ += metres;
    deep_ += metres * away_;
    if (part_ == Part::Down)
        followPlaces();
    else if (part_ == Part::None)
        lead(goal_ + metres * (goal_ - camera.eye()).normalized());
}

void HandTool::nudge(const Vec3& steps, const ViewCamera& camera) {
    part_ = Part::None;
    lead(goal_ + kStep * sceneSize_ *
                     (steps.x() * camera.right() + steps.y() * camera.up() + steps.z() * camera.forward()));
}

bool HandTool::advance(double seconds) {
    if (!moves() || part_ == Part::Done) return false;
    if (part_ != Part::Way) {
        partTime_ += seconds;
        if (partTime_ >= partDuration_) next();
        return true;
    }
    // The next part begins when the hand has come to the end of this one, not when it is told of it.
    if (partTime_ >= partDuration_) {
        next();
        return true;
    }
    partTime_ += std::min(seconds, kLongestGlideStep);
    goal_ = glide_.at(eased(partDuration_ > 0 ? std::min(1.0, partTime_ / partDuration_) : 1));
    time_ = std::max(seconds, kFollowTime);
    return true;
}

} // namespace tactum
