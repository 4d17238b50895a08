#include "core/port/workspace.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace tactum {

namespace {
constexpr double kLongest = 0.01; ///< s: a loop that stood still stood still
} // namespace

Result<void> checkWorkspace(const Workspace& workspace) {
    if (!(workspace.scale >= kMinScale && workspace.scale <= kMaxScale))
        return inputError("The workspace's scale must be from 0.001 to 10000: choose another one.");
    AxisMap axes = workspace.axes;
    for (std::int8_t& axis : axes)
        axis = std::int8_t(std::abs(axis));
    std::ranges::sort(axes);
    if (axes != kSameAxes)
        return inputError("Each axis of the device must be used once: choose another mapping of the axes.");
    if (!workspace.offset.allFinite())
        return inputError("The workspace's centre is no place: centre it anew.");
    if (std::size_t(workspace.reach.mode) >= kReachModes)
        return inputError("A hand reaches by position, rate or drift: choose one of them.");
    if (!(workspace.reach.shell >= kMinShell && workspace.reach.shell <= kMaxShell))
        return inputError("The shell's radius must be from 5 to 500 mm: choose another one.");
    return {};
}

/// Whether that moves the finger.
bool WorkspaceTracker::obey() noexcept {
    if (!std::exchange(decided_, false)) return false;
    const DeviceFrame before = frame_;
    if (decision_.offset != workspace_.offset || decision_.centring != workspace_.centring)
        frame_.offset = decision_.offset;
    frame_.scale = decision_.scale;
    frame_.axes = decision_.axes;
    workspace_ = decision_;
    reach_.decide(workspace_.reach);
    return frame_ != before;
}

/// Between kBumpFrom and the edge ever faster: a finger that crosses the border feels no step.
void WorkspaceTracker::bump(const Vec3& position, double dt) noexcept {
    const double distance = position.norm(), border = kBumpFrom * radius_;
    if (!(distance > border)) return;
    const double part = std::min(1.0, (distance - border) / (radius_ - border));
    frame_.offset += frame_.wayInWorld(kBumpSpeed * part * dt / distance * position);
}

void WorkspaceTracker::reach(const DeviceSample& sample, const AroundHand& around, double dt) noexcept {
    if (!around.forces || clutched_ || sample.jumped || jumped_) return reach_.rest(sample.position);
    const Vec3 way = reach_.way(sample.position, dt);
    if (way.isZero(0)) return;
    frame_.offset += wayAlong(frame_.wayInWorld(way), frame_.pointInWorld(sample.position),
                              std::span(around.wall).first(around.walls));
}

const DeviceFrame& WorkspaceTracker::follow(const DeviceSample& sample, const AroundHand& around,
                                            double dt) noexcept {
    dt = std::min(dt, kLongest);
    jumped_ = false;
    if (!sample.valid || !sample.position.allFinite()) return frame_;
    jumped_ = obey();
    clutched_ = (sample.buttons & workspace_.clutch) != 0;
    if (clutched_ && known_ && !sample.jumped)
        frame_.offset -= frame_.wayInWorld(sample.position - last_);
    else if (workspace_.bump && workspace_.reach.mode != ReachMode::Rate && radius_ > 0 && !around.pushing)
        bump(sample.position, dt);
    reach(sample, around, dt);
    last_ = sample.position;
    known_ = true;
    return frame_;
}

} // namespace tactum
