// Everything that crosses a thread, in one place.
//
//   ui ----- World (pointer hand-over) ---------> proxy      proxy -- old World (retire queue) --> ui
//   ui ----- EngineCommand (queue) -------------> proxy
//   ui ----- Workspace, OutsidePush (newest) ---> servo
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
#include "core/haptics/haptic_step.h"
#include "core/haptics/world.h"
#include "core/port/workspace.h"
#include "core/runtime/recorder.h"
#include "core/runtime/servo_telemetry.h"
#include "core/runtime/trace_point.h"

namespace tactum {

/// What the proxy loop tells the window of one hand.
struct TouchTelemetry {
    HapticOutput output;        ///< of the last update
    Vec3 finger = Vec3::Zero(); ///< that the update used
    Coupling coupling{};        ///< of the last update: with what it pushed bodies
};

/// What it tells of what all hands share.
struct WorldTelemetry {
    std::uint64_t updates = 0;
    std::uint64_t worldRevision = 0; ///< the World that the update used
    std::uint64_t worldSince = 0;    ///< the first update that used it
    double rate = 0;                 ///< Hz, over the last half second
    double updateMicros = 0;         ///< mean time of hapticStep over the last half second
    double worstUpdateMicros = 0;    ///< largest of it
    std::uint64_t boundHits = 0;     ///< steps of a hand that ended at their iteration bound
    std::uint64_t squeezed = 0; ///< steps of a hand in which surfaces left the proxy less room than it needs
    std::uint64_t passed = 0;   ///< steps of a hand in which a moving body had to pass over the proxy
    double time = 0;            ///< s, of the bodies that move by themselves
    BodiesState bodies;         ///< of those that forces move
    Fidelity fidelity = Fidelity::Full;
    std::uint64_t stepsDown = 0; ///< how often the fidelity was lowered
};

/// The first hand, and what it shares with others.
struct ProxyTelemetry : TouchTelemetry, WorldTelemetry {};

/// What the servo renders, and how many steps of the proxy led to it.
struct NumberedModel {
    LocalContactModel model;
    std::uint64_t steps = 0;
};

/// Small orders to the proxy loop.
struct EngineCommand {
    enum class Kind : std::uint8_t {
        RestartProxy,
        BeginBodies, ///< they go back to the time 0
        StepBodies   ///< they go on for one step, whatever their pace
    };
    Kind kind = Kind::RestartProxy;
};

struct Channels {
    /// Rates of the loops in Hz, for the recorder's memory.
    explicit Channels(double servoRate = 1000, double proxyRate = 2000) : recorder(servoRate, proxyRate) {}

    std::atomic<const World*> worldIn{nullptr};
    SpscQueue<const World*, 64> worldOut;
    SpscQueue<EngineCommand, 64> commands;
    TripleBuffer<Workspace> workspace;
    TripleBuffer<OutsidePush> outside;
    TripleBuffer<FingerSample> finger;
    TripleBuffer<NumberedModel> contactModel;
    TripleBuffer<ProxyTelemetry> proxyTelemetry;
    TripleBuffer<ServoTelemetry> servoTelemetry;
    SpscQueue<TracePoint, 8192> trace;
    Recorder recorder;
    std::atomic<bool> armed{false};           ///< false: the servo commands zero force
    std::atomic<bool> fading{false};          ///< when it is not armed: gently
    std::atomic<std::uint32_t> deadMan{0};    ///< buttons of which one must be held; 0: none
    std::atomic<bool> overrideCeiling{false}; ///< the person knows better than safeStiffness()
    std::atomic<bool> grasped{false};         ///< the person says that the whole hand holds the device
    std::atomic<double> pace{1};              ///< BodiesTime::pace
    std::atomic<bool> stop{false};
};

} // namespace tactum
