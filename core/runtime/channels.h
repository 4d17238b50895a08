// Everything that crosses a thread, in one place.
//
//   ui ----- World (pointer hand-over) ---------> proxy      proxy -- old World (retire queue) --> ui
//   ui ----- EngineCommand (queue) -------------> proxy
//   ui ----- Workspace, OutsidePush (newest) ---> servo
//   servo -- FingerSample (newest) -------------> proxy
//   proxy -- LocalContactModel (newest) --------> servo
//   proxy -- Touch-, ProxyTelemetry (newest) ---> ui         servo -- ServoTelemetry (newest) ---> ui
//   servo -- TracePoint (queue) ----------------> ui
//   both --- rows and states (Recorder) --------> ui
//
// Of several hands each has a servo and HandChannels of its own; the proxy loop is one.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/vec.h"
#include "core/base/wait_free.h"
#include "core/haptics/haptic_step.h"
#include "core/haptics/touched_place.h"
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

/// What the servo renders, how many steps of the proxy led to it, and what the last of them touched.
struct NumberedModel {
    LocalContactModel model;
    std::uint64_t steps = 0;
    TouchedPlace touched{};
};

/// Small orders to the proxy loop.
struct EngineCommand {
    enum class Kind : std::uint8_t {
        RestartProxy,
        BeginBodies, ///< they go back to the time 0
        StepBodies   ///< they go on for one step, whatever their pace
    };
    Kind kind = Kind::RestartProxy;
    std::size_t hand = 0; ///< whose proxy
};

/// What crosses threads of one hand.
struct HandChannels {
    /// Rates of the loops in Hz, for the recorder's memory; `start` as of Recorder.
    HandChannels(double servoRate, double proxyRate, std::int64_t start)
        : recorder(servoRate, proxyRate, start) {}

    TripleBuffer<Workspace> workspace;
    TripleBuffer<OutsidePush> outside;
    TripleBuffer<FingerSample> finger;
    TripleBuffer<NumberedModel> contactModel;
    TripleBuffer<TouchTelemetry> touchTelemetry; ///< of a hand beside the first
    TripleBuffer<ServoTelemetry> servoTelemetry;
    SpscQueue<TracePoint, 8192> trace;
    Recorder recorder;
    std::atomic<bool> armed{false};           ///< false: the servo commands zero force
    std::atomic<bool> fading{false};          ///< when it is not armed: gently
    std::atomic<std::uint32_t> deadMan{0};    ///< buttons of which one must be held; 0: none
    std::atomic<bool> overrideCeiling{false}; ///< the person knows better than safeStiffness()
    std::atomic<bool> grasped{false};         ///< the person says that the whole hand holds the device
    std::atomic<bool> stop{false};            ///< ends the servo; that of the first hand the proxy loop, too
};

/// The first hand, what all hands share, and the others.
struct Channels : HandChannels {
    /// Of one hand. Rates in Hz.
    explicit Channels(double servoRate = 1000, double proxyRate = 2000)
        : Channels(std::span(&servoRate, 1), proxyRate) {}
    /// One rate of a servo for each hand, 1 to kMaxHands. Thread: any but real time.
    Channels(std::span<const double> servoRates, double proxyRate,
             std::int64_t start = monotonicNanoseconds())
        : HandChannels(servoRates.front(), proxyRate, start) {
        for (const double rate : servoRates.subspan(1))
            others.push_back(std::make_unique<HandChannels>(rate, proxyRate, start));
    }

    std::size_t hands() const noexcept { return 1 + others.size(); }
    /// i < hands().
    HandChannels& hand(std::size_t i) noexcept { return i == 0 ? *this : *others[i - 1]; }

    std::atomic<const World*> worldIn{nullptr};
    SpscQueue<const World*, 64> worldOut;
    SpscQueue<EngineCommand, 64> commands;
    TripleBuffer<ProxyTelemetry> proxyTelemetry;
    std::atomic<double> pace{1}; ///< BodiesTime::pace
    std::vector<std::unique_ptr<HandChannels>> others;
};

} // namespace tactum
