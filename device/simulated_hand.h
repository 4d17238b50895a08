// A device that everyone has: a mass that a spring and a damper pull to where the mouse is.
#pragma once

#include <memory>
#include <string_view>

#include "core/port/hand_target.h"
#include "core/port/haptic_device.h"
#include "core/port/minimum_jerk.h"

namespace tactum {

/// What it is called, for a person; a window says it in its own language.
inline constexpr std::string_view kSimulatedHandName = "Simulated hand";

/// The hand and the moving parts of a device as one point mass. Assumed values, near a firm pinch grip on a
/// desktop device; not a calibration. A surface of stiffness K, rendered every T seconds and one tick late,
/// is calm while damping > K (T/2 + T): 8 N s/m leave a third in reserve at 3000 N/m and 1 kHz.
struct SimulatedHandProfile {
    double mass = 0.1;             ///< kg
    double damping = 8;            ///< N s/m, of the grip against the goal's frame
    double stiffness = 250;        ///< N/m, of the grip
    double maxForce = 8;           ///< N
    double workspaceRadius = 0.15; ///< m
};

/// mass x" = stiffness (goal - x) - damping x' + force, inside a ball whose wall stops the outward motion.
/// The force really pushes: on the spring it moves the hand by force / stiffness.
/// Where it is led goes to each new goal in the goal's time, with the least jerk. Solved exactly over each
/// tick for a constant force, led to where the tick's middle has it, so that it is stable for every dt; a dt
/// above 20 ms (the machine slept) counts as 20 ms. Its button is down while the goal is held. Position is a
/// plain double: there is no encoder.
class SimulatedHand final : public HapticDevice {
public:
    /// `target` is written by whoever leads the hand and shared with them.
    explicit SimulatedHand(std::shared_ptr<HandTarget> target, SimulatedHandProfile profile = {});

    DeviceInfo info() const override;
    Result<void> open() override; ///< at rest at the origin, or where the first teleport says
    void close() override;
    DeviceSample exchange(const DeviceCommand& command, double dt) noexcept override;

private:
    bool obey(const HandGoal& goal) noexcept; ///< whether it jumped there
    void lead(const Vec3& goal, double seconds) noexcept;
    void move(const Vec3& force, double dt) noexcept;
    void stayInside() noexcept;

    std::shared_ptr<HandTarget> target_;
    SimulatedHandProfile profile_;
    Vec3 goal_ = Vec3::Zero();
    MinimumJerk course_;  ///< toward the goal
    double underWay_ = 0; ///< s, since it began
    Vec3 position_ = Vec3::Zero();
    Vec3 velocity_ = Vec3::Zero();
    bool held_ = false;
    std::uint32_t teleported_ = 0; ///< sequence of the last teleport
};

} // namespace tactum
