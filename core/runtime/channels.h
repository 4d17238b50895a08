// Everything that crosses a thread, in one place.
//
//   ui ----- World (pointer hand-over) ---------> proxy      proxy -- old World (retire queue) --> ui
//   ui ----- EngineCommand (queue) -------------> proxy
//   servo -- FingerSample (newest) -------------> proxy
//   proxy -- LocalContactModel (newest) --------> servo
//   proxy -- ProxyTelemetry (newest) -----------> ui         servo -- ServoTelemetry (newest) ---> ui
//   servo -- TracePoint (queue) ----------------> ui
//   both --- rows and states (Recorder) --------> ui
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "core/base/vec.h"
#include "core/base/wait_free.h"
#include "core/runtime/haptic_step.h"
#include "core/runtime/period_histogram.h"
#include "core/runtime/recorder.h"
#include "core/runtime/servo_step.h"
#include "core/runtime/world.h"

namespace tactum {

/// What the proxy loop tells the window.
struct ProxyTelemetry {
    HapticOutput output;        ///< of the last update
    Vec3 finger = Vec3::Zero(); ///< that the update used
    std::uint64_t updates = 0;
    std::uint64_t worldRevision = 0; ///< the World that the update used
    double rate = 0;                 ///< Hz, over the last half second
    double updateMicros = 0;         ///< mean time of hapticStep over the last half second
    double worstUpdateMicros = 0;    ///< largest of it
    std::uint64_t boundHits = 0;     ///< steps that ended at their iteration bound
    std::uint64_t squeezed = 0;      ///< steps in which surfaces left the proxy less room than it needs
    std::uint64_t passed = 0;        ///< steps in which a moving body had to pass over the proxy
    double time = 0;                 ///< s, of the bodies that move by themselves
    Fidelity fidelity = Fidelity::Full;
    std::uint64_t stepsDown = 0; ///< how often the fidelity was lowered
};

/// What the servo loop tells the window.
struct ServoTelemetry {
    Vec3 finger = Vec3::Zero();
    Vec3 force = Vec3::Zero(); ///< N, after the limiter: what the device was sent
    std::uint64_t ticks = 0;
    double rate = 0;                 ///< Hz, over the last half second
    double jitterMicros = 0;         ///< largest deviation of a period from its nominal length over it
    std::uint64_t misses = 0;        ///< ticks that came more than one period late
    std::uint64_t machineMisses = 0; ///< those of them that no program could have avoided (Canary)
    PeriodHistogram periods;         ///< deviations, since the start
    std::uint64_t clamped = 0;       ///< commands that the limiter shortened
    std::uint64_t invalidSamples = 0;
    Withheld withheld = Withheld::NotArmed; ///< why there is no force, or less of it
    double gain = 0;                        ///< of the force: 0 none, 1 all
    std::uint64_t faults = 0;
    std::uint64_t pauses = 0;               ///< how often force was taken away without a fault
    Withheld lastPause = Withheld::Nothing; ///< why, the last time: it may be over within a tick
    std::uint64_t oscillations = 0;         ///< limit cycles that were noticed
    double calm = 1;                        ///< part of the stiffness that is left after them
    double heat = 0;                        ///< of the motors: 1 is as warm as they may be for ever
    double energy = 0;                      ///< J that the surface gave beyond what it took
    double passivityDamping = 0;            ///< N s/m, that takes it back
    StiffnessCeiling ceiling;
};

/// What the servo renders, and how many steps of the proxy led to it.
struct NumberedModel {
    LocalContactModel model;
    std::uint64_t steps = 0;
};

/// One servo tick, for plots.
struct TracePoint {
    double t = 0; ///< s since the start
    Vec3 finger = Vec3::Zero();
    Vec3 proxy = Vec3::Zero();
    Vec3 force = Vec3::Zero();
};

/// Small orders to the proxy loop.
struct EngineCommand {
    enum class Kind : std::uint8_t { RestartProxy };
    Kind kind = Kind::RestartProxy;
};

struct Channels {
    /// Rates of the loops in Hz, for the recorder's memory.
    explicit Channels(double servoRate = 1000, double proxyRate = 2000) : recorder(servoRate, proxyRate) {}

    std::atomic<const World*> worldIn{nullptr};
    SpscQueue<const World*, 64> worldOut;
    SpscQueue<EngineCommand, 64> commands;
    TripleBuffer<FingerSample> finger;
    TripleBuffer<NumberedModel> contactModel;
    TripleBuffer<ProxyTelemetry> proxyTelemetry;
    TripleBuffer<ServoTelemetry> servoTelemetry;
    SpscQueue<TracePoint, 8192> trace;
    Recorder recorder;
    std::atomic<bool> armed{false};           ///< false: the servo commands zero force
    std::atomic<bool> overrideCeiling{false}; ///< the person knows better than safeStiffness()
    std::atomic<bool> stop{false};
};

} // namespace tactum
