// How the workspace moves by itself: rate control beyond a shell, or a slow drift.
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "core/base/reach.h"
#include "core/base/vec.h"
#include "core/port/haptic_device.h"

namespace tactum {

/// The shell is at most this part of the device's workspace: beyond it there must be room to pull.
inline constexpr double kShellMost = 0.9;

/// The workspace's speed for each metre beyond the shell, and the most, in the hand's measure. Units: 1/s,
/// m/s.
inline constexpr double kRateSlope = 20, kRateMost = 0.2;
/// So much of the hand's way the workspace drifts at the edge of the device's workspace, and in proportion
/// nearer to its centre: a tenth is below what people notice of a hand that they move themselves.
inline constexpr double kDriftPart = 0.1;

/// m/s in the hand's measure, for so many metres beyond the border: without a step there, and bounded.
inline double rateSpeed(double excess) noexcept {
    return std::clamp(kRateSlope * excess, 0.0, kRateMost);
}

/// What is touched: all p_W with normal . p_W < offset. World frame, m.
struct Wall {
    Vec3 normal = Vec3::UnitY();
    double offset = 0;
};

/// Room for more walls than push at once.
inline constexpr std::size_t kMaxWalls = 4;

/// What the servo knows of a hand when it is read.
struct AroundHand {
    bool forces = false;  ///< the device may push: without them no workspace moves by itself
    bool pushing = false; ///< the last command was not zero
    std::array<Wall, kMaxWalls> wall{};
    std::size_t walls = 0;
};

/// `way` of a finger at `finger` without what of it leads into walls: along them, or none at all where it
/// fits between no two of them. What presses already is not pressed deeper; what is not reached is reached
/// and not passed. World frame, m. Thread: real time.
Vec3 wayAlong(const Vec3& way, const Vec3& finger, std::span<const Wall> walls) noexcept;

/// How the workspace moves by itself, tick by tick. Frame D, the hand's measure. Thread: real time.
class ReachTracker {
public:
    explicit ReachTracker(const DeviceInfo& device) noexcept
        : radius_(device.workspaceRadius), resolution_(device.positionResolution) {}

    /// Another decision begins where the hand is: without force and speed.
    void decide(const Reach& reach) noexcept;
    /// Where nothing may move by itself: without forces, under the clutch. A hand that is beyond the shell
    /// when this ends has the border with it, and takes it home.
    void rest(const Vec3& position) noexcept;
    /// The way of the workspace in this tick, m.
    Vec3 way(const Vec3& position, double dt) noexcept;

    /// m about the device's centre: from where on speed and force begin. 0: no border is felt.
    double border() const noexcept { return reach_.mode == ReachMode::Rate ? border_ : 0; }

private:
    double shell() const noexcept;
    Vec3 drift(const Vec3& position) noexcept;

    double radius_, resolution_; ///< m
    Reach reach_;
    bool resting_ = true;
    double border_ = 0;
    Vec3 held_ = Vec3::Zero(); ///< what the hand has not left by more than a count
};

} // namespace tactum
