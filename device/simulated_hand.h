// A device that everyone has: a mass that a spring and a damper pull to where the mouse is.
#pragma once

#include <memory>

#include "core/control/hand_target.h"
#include "core/control/haptic_device.h"

namespace tactum {

/// The hand and the moving parts of a device as one point mass. Assumed values, near a light pinch grip on a
/// desktop device; not a calibration.
struct SimulatedHandProfile {
    double mass = 0.1;        ///< kg
    double damping = 4;       ///< N s/m, of the grip against the goal's frame
    double stiffness = 250;   ///< N/m, of the grip
    double maxForce = 8;      ///< N
    double workspaceRadius = 0.15; ///< m
};

class SimulatedHand final : public HapticDevice {
public:
    /// `target` is written by whoever leads the hand, and must outlive nothing: it is shared.
    explicit SimulatedHand(std::shared_ptr<HandTarget> target, SimulatedHandProfile profile = {});

    DeviceInfo info() const override;
    Result<void> open() override;
    void close() override;
    DeviceSample exchange(const DeviceCommand& command, double dt) noexcept override;

private:
    std::shared_ptr<HandTarget> target_;
    SimulatedHandProfile profile_;
    Vec3 position_ = Vec3::Zero();
    Vec3 velocity_ = Vec3::Zero();
    std::uint32_t teleported_ = 0;
};

} // namespace tactum
