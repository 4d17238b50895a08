// What the servo loop tells the window, live or from a recording.
#pragma once

#include "core/runtime/period_histogram.h"
#include "core/safety/servo_step.h"

namespace tactum {

struct ServoTelemetry {
    Vec3 finger = Vec3::Zero();   ///< world, m
    Vec3 force = Vec3::Zero();    ///< N, after the limiter: what the device was sent, in the world's frame
    Vec3 handle_D = Vec3::Zero(); ///< m: where the device is
    DeviceFrame frame;            ///< of the device in the scene, as clutch and bump have moved it
    double border = 0;            ///< m about the device's centre, where rate control begins; 0: nowhere
    std::uint32_t buttons = 0;    ///< that are held
    std::uint64_t ticks = 0;
    double rate = 0;                 ///< Hz, over the last half second
    double jitterMicros = 0;         ///< largest deviation of a period from its nominal length over it
    std::uint64_t misses = 0;        ///< ticks that came more than one period late
    std::uint64_t machineMisses = 0; ///< those of them that no program could have avoided (LatencyMonitor)
    PeriodHistogram periods;         ///< deviations, of the last five to ten seconds
    std::uint64_t clamped = 0;       ///< commands that the limiter shortened
    std::uint64_t invalidSamples = 0;
    InhibitReason inhibit = InhibitReason::NotArmed; ///< why there is no force, or less of it
    double gain = 0;                                 ///< of the force: 0 none, 1 all
    std::uint64_t faults = 0;
    std::uint64_t pauses = 0;                         ///< how often force was taken away without a fault
    InhibitReason lastPause = InhibitReason::Nothing; ///< why, the last time: it may be over within a tick
    std::uint64_t oscillations = 0;                   ///< limit cycles that were noticed
    double stiffnessScale = 1;                        ///< part of the stiffness that is left after them
    double heat = 0;                                  ///< of the motors: 1 is as warm as they may be for ever
    double energy = 0;                                ///< J that the surface gave beyond what it took
    double passivityDamping = 0;                      ///< N s/m, that takes it back
    double rendered = 0;      ///< N/m, of what is touched, in the scene's measure; 0: nothing is
    bool grasped = false;     ///< the whole hand is believed to hold the device
    bool doubted = false;     ///< the person says that it does, and is not believed any more
    StiffnessCeiling ceiling; ///< of surfaces in the scene: of the hand's measure, less the workspace's scale
};

/// Everything that a tick itself tells. When the ticks came is for whoever has a clock: rate, jitter, periods
/// and misses stay as they are. Call it after each tick: it counts pauses. Thread: real time.
void note(ServoTelemetry& telemetry, const ServoOutput& output, const ServoState& state) noexcept;

} // namespace tactum
