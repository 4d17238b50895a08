#include "core/safety/stiffness_schedule.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/safety/contact_transition.h"
#include "core/safety/passivity.h"

namespace tactum {
namespace {

/// After a limit cycle the stiffness falls to its half over the first time, and doubles again over the
/// second. Where the surface gives energy faster than it is taken back there is less time. Unit: s.
constexpr double kFade = 0.05, kRecovery = 2, kSoften = 0.0125;
constexpr double kMinScale = 1.0 / 32; ///< softer than that nothing is felt of a surface of 1000 N/m
/// So many late ticks in a row are no accident: the loop is slower than it should be.
constexpr int kLateTicks = 5;
/// A whole hand damps so many times as much as a light pinch. Unit of the second: N/m; beyond it taps in a
/// grasp were taken for swings, on devices that damping alone would let be stiffer (docs/stability.md).
constexpr double kGrasp = 1.7, kGraspCeiling = 1850;
/// What is softened below this part of its stiffness is a doubt of the grasp; so many end it, and one is
/// forgotten in this time. Unit: s.
constexpr double kSoftened = 0.9, kMostDoubts = 2.5, kForgiven = 120;

} // namespace

// A machine that is in time again is believed no faster than an edit under load; without, within some
// seconds.
void StiffnessSchedule::keepTime(const ScheduleInput& tick, double change) noexcept {
    lateFor_ = tick.late ? lateFor_ + tick.dt : 0;
    lateTicks_ = tick.late ? lateTicks_ + 1 : 0;
    const double now = lateTicks_ > kLateTicks ? lateFor_ / lateTicks_ : 0;
    const double falls = tick.load > 0 ? std::max(0.0, 1 - change) : std::exp2(-tick.dt / kRecovery);
    period_ = std::max({loop_.period, tick.period, now, period_ * falls});
}

// A whole hand lets a surface be stiffer by as much as it takes up more of what that makes.
bool StiffnessSchedule::overspent(const ScheduleInput& tick) const noexcept {
    return tick.made > (grasping_ ? kGrasp : 1) * kSofteningThreshold;
}

void StiffnessSchedule::scaleBy(const ScheduleInput& tick) noexcept {
    if (!(tick.load > 0)) // nothing is touched
        goal_ = std::min(1.0, goal_ * std::exp2(tick.dt / kRecovery));
    else if (tick.pushing && overspent(tick))
        goal_ = std::max(kMinScale, goal_ * std::exp2(-tick.dt / kSoften));
    scale_ = std::min(
        1.0, scale_ + std::clamp(goal_ - scale_, -0.5 * tick.dt / (overspent(tick) ? kSoften : kFade), 1.0));
    if (tick.seen.jumped) oscillation_.forget();
    if (!oscillation_(tick.seen.position, tick.dt) || !tick.pushing) return;
    ++oscillations_;
    goal_ = std::max(kMinScale, 0.5 * goal_);
}

void StiffnessSchedule::trust(const ScheduleInput& tick, bool loaded) noexcept {
    const bool softened = goal_ < kSoftened;
    doubts_ = tick.grasped ? std::max(0.0, doubts_ - tick.dt / kForgiven) : 0;
    if (grasping_ && softened && !softened_) doubts_ += 1;
    softened_ = softened;
    doubted_ = tick.grasped && (doubted_ || doubts_ > kMostDoubts);
    grasping_ = tick.grasped && !doubted_ && (grasping_ || !loaded);
}

/// What a device bears without a grasp it bears with it.
void StiffnessSchedule::grasp(LoopFigures& loop) const noexcept {
    loop.handsCeiling = std::max(safeStiffness(loop).value, kGraspCeiling);
    loop.damping += (kGrasp - 1) * pinch_;
}

StiffnessBounds StiffnessSchedule::operator()(const ScheduleInput& tick) noexcept {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    scaleBy(tick);
    const bool loaded = tick.load > 0 && tick.pushing;
    keepTime(tick, loaded ? editRate(tick.rendered) * tick.dt / tick.load : 1);
    overriding_ = tick.overrideCeiling && (overriding_ || !loaded);
    trust(tick, loaded);

    LoopFigures loop = loop_;
    loop.period = period_;
    if (grasping_) grasp(loop);
    const double undamped = safeStiffness(loop).value;
    loop.surfaceDamping = tick.damping;
    ceiling_ = safeStiffness(loop);
    if (overriding_) return {scale_ * tick.stiffness, scale_ * tick.damping, kNone};
    return {scale_ * std::min(tick.stiffness, ceiling_.value),
            scale_ * std::min(tick.damping, ceiling_.damping), scale_ * undamped};
}

} // namespace tactum
