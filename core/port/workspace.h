// How a person has laid the device's workspace into the scene, and how it moves along.
#pragma once

#include "core/base/result.h"
#include "core/port/device_frame.h"
#include "core/port/haptic_device.h"
#include "core/port/reach_tracker.h"

namespace tactum {

/// Of Workspace::scale: from a watch under the finger to a city.
inline constexpr double kMinScale = 1e-3, kMaxScale = 1e4;

/// What the person decides; it belongs to the device and not to the scene, but for `reach`.
struct Workspace {
    double scale = 1;           ///< as in DeviceFrame
    AxisMap axes = kSameAxes;   ///< as in DeviceFrame
    Vec3 offset = Vec3::Zero(); ///< world, m: where the device's centre is before clutch and bump move it
    std::uint32_t clutch = 0;   ///< buttons: while one is held the device moves and the finger stays
    bool bump = false;          ///< a finger at the edge of the workspace takes it along
    Reach reach{};              ///< beyond the workspace; of the scene
    std::uint32_t centring = 0; ///< another number than before: what clutch and bump moved is forgotten

    bool operator==(const Workspace&) const = default;
};

/// A sentence when it cannot be. Thread: any but real time.
Result<void> checkWorkspace(const Workspace& workspace);

/// From so much of the workspace's radius on it is taken along, and so fast at the full radius; in the hand's
/// measure. Unit of the second: m/s.
inline constexpr double kBumpFrom = 0.85, kBumpSpeed = 0.1;

/// Where the workspace is, tick by tick. Thread: real time.
class WorkspaceTracker {
public:
    explicit WorkspaceTracker(const DeviceInfo& device) noexcept
        : radius_(device.workspaceRadius), reach_(device) {}

    /// Clutch and bump hold on to what they moved, unless offset or centring are new ones. Call it when there
    /// is a new decision, else not. It counts from the next reading that is valid.
    void decide(const Workspace& workspace) noexcept {
        decision_ = workspace;
        decided_ = true;
    }
    /// The frame of this reading, which is not valid if it cannot be true (SampleCheck). A device that pushes
    /// takes nothing along at its edge, or a wall would be pushed against a resting hand; rate control and
    /// drift lead the finger along what it touches and never into it.
    const DeviceFrame& follow(const DeviceSample& sample, const AroundHand& around, double dt) noexcept;

    bool clutched() const noexcept { return clutched_; } ///< in this reading
    /// The finger was put elsewhere by a decision since the last reading that was valid.
    bool jumped() const noexcept { return jumped_; }
    /// As ReachTracker::border().
    double border() const noexcept { return reach_.border(); }

private:
    bool obey() noexcept;
    void bump(const Vec3& position, double dt) noexcept;
    void reach(const DeviceSample& sample, const AroundHand& around, double dt) noexcept;

    double radius_; ///< m, of the device's workspace; 0: not known, it never bumps
    ReachTracker reach_;
    Workspace workspace_, decision_;
    bool decided_ = false; ///< and not yet obeyed
    DeviceFrame frame_;
    bool clutched_ = false;
    bool jumped_ = false;
    bool known_ = false;
    Vec3 last_ = Vec3::Zero(); ///< frame D, of the last reading that was valid
};

} // namespace tactum
