#include "core/runtime/proxy_loop.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "core/base/realtime.h"
#include "core/loop/metronome.h"

namespace tactum {
namespace {

template <class T> using PerHand = std::array<T, std::size_t(kMaxHands)>;

/// Of every hand.
using Fingers = PerHand<FingerSample>;

/// What the proxy loop remembers from step to step.
struct Proxy {
    Channels& channels;
    const World* world = nullptr;
    PerHand<bool> restartDue{};         ///< the next step begins at the finger
    bool beginDue = false;              ///< the next step begins with the bodies where they began
    bool stepDue = false;               ///< the bodies go on in the next step
    PerHand<std::uint32_t> anchoring{}; ///< of the last finger
    DegradationController ladder;
    SimState state{};
    std::vector<HandState> others; ///< the second hand and so on
    HandState rehearsed{};         ///< thrown away each time
    Fingers fingers{};             ///< as the last step had them
    double took = 0;               ///< s, the last step
    HalfSecond updates{};
    ProxyTelemetry telemetry{};
    double begun = 0; ///< s, when the metronome was made, on the recorder's clock
};

const HandState& stateOf(const Proxy& proxy, std::size_t hand) noexcept {
    return hand == 0 ? proxy.state : proxy.others[hand - 1];
}

/// The load first: an exchange at every tick would take the cache line from the ui thread for nothing.
void takeWorld(Proxy& proxy) noexcept {
    std::atomic<const World*>& in = proxy.channels.worldIn;
    if (!in.load(std::memory_order_relaxed)) return;
    const World* next = in.exchange(nullptr, std::memory_order_acquire);
    if (!next) return;
    // Never full: the ui thread empties it at each publish(), and no more come back than were published.
    if (proxy.world) proxy.channels.worldOut.push(proxy.world);
    proxy.world = next;
}

/// False when there is none of any hand.
bool takeFingers(Channels& channels, Fingers& fingers) noexcept {
    bool any = false;
    for (std::size_t i = 0; i < channels.hands(); ++i) {
        fingers[i] = channels.hand(i).finger.read();
        any |= fingers[i].valid;
    }
    return any;
}

void obeyCommands(Proxy& proxy) noexcept {
    EngineCommand command;
    while (proxy.channels.commands.pop(command)) {
        switch (command.kind) {
        case EngineCommand::Kind::RestartProxy:
            proxy.restartDue[command.hand] = true;
            break;
        case EngineCommand::Kind::BeginBodies:
            proxy.beginDue = true;
            break;
        case EngineCommand::Kind::StepBodies:
            proxy.stepDue = true;
            break;
        }
    }
}

std::uint32_t flagsOf(bool restart, bool found, Fidelity fidelity) noexcept {
    return (restart ? std::uint32_t(ProxyRow::Restart) : 0) | (found ? std::uint32_t(ProxyRow::Found) : 0) |
           std::uint32_t(fidelity) << ProxyRow::kFidelity;
}

/// What one hand brings into the step; of what all share only what is in `shared`.
ProxyRow rowOf(Proxy& proxy, std::size_t hand, const FingerSample& finger, const ProxyRow& shared) noexcept {
    ProxyRow row = shared;
    row.anchoring = proxy.anchoring[hand];
    if (!finger.valid) {
        row.flags |= ProxyRow::Absent | flagsOf(false, false, proxy.ladder.fidelity());
        return row;
    }
    const bool restart = std::exchange(proxy.restartDue[hand], false);
    const bool found = !restart && finger.anchoring != proxy.anchoring[hand];
    proxy.anchoring[hand] = row.anchoring = finger.anchoring;
    row.coupling = {finger.coupling.stiffness, finger.coupling.force, finger.coupling.delay};
    row.finger = tripleOf(finger.position);
    row.velocity = tripleOf(finger.velocity);
    row.flags |= flagsOf(restart, found, proxy.ladder.fidelity());
    return row;
}

PerHand<HapticOutput> step(Proxy& proxy, const Fingers& fingers, const Tick& tick) noexcept {
    const bool begin = std::exchange(proxy.beginDue, false);
    const bool goesOn = std::exchange(proxy.stepDue, false);
    const ProxyRow shared{.time = proxy.begun + tick.time,
                          .dt = std::clamp(tick.elapsed, kShortestStep, kLongestStep),
                          .pace = goesOn ? 1 : proxy.channels.pace.load(std::memory_order_relaxed),
                          .world = proxy.world->revision,
                          .flags = begin ? std::uint32_t(ProxyRow::Begin) : 0};
    const std::size_t hands = proxy.channels.hands();
    PerHand<ProxyRow> rows;
    PerHand<HapticOutput> outputs;
    for (std::size_t i = 0; i < hands; ++i) {
        rows[i] = rowOf(proxy, i, fingers[i], shared);
        Recorder& recorder = proxy.channels.hand(i).recorder;
        if (i == 0)
            recorder.begin(rows[i], proxy.state);
        else
            recorder.begin(rows[i], proxy.others[i - 1]);
    }
    stepFrom({rows.data(), hands}, *proxy.world, proxy.state, proxy.others, outputs);
    // Before any model is published: no row of a servo names a step that is not there of every hand.
    for (std::size_t i = 0; i < hands; ++i) {
        note(rows[i], outputs[i]);
        proxy.channels.hand(i).recorder.end(rows[i]);
    }
    return outputs;
}

void publishModels(Proxy& proxy, const PerHand<HapticOutput>& outputs) noexcept {
    for (std::size_t i = 0; i < proxy.channels.hands(); ++i) {
        HandChannels& hand = proxy.channels.hand(i);
        hand.contactModel.write(
            {stateOf(proxy, i).model, hand.recorder.proxyCount(), touchedPlace(outputs[i], *proxy.world)});
    }
}

void reportOthers(Proxy& proxy, const PerHand<HapticOutput>& outputs, const Fingers& fingers) noexcept {
    for (std::size_t i = 1; i < proxy.channels.hands(); ++i) {
        proxy.channels.hand(i).touchTelemetry.write(
            {outputs[i], fingers[i].position, proxy.others[i - 1].press.coupling});
        proxy.telemetry.boundHits += outputs[i].report.boundHit;
        proxy.telemetry.squeezed += outputs[i].report.squeezed;
        proxy.telemetry.passed += outputs[i].report.passed;
    }
}

void report(Proxy& proxy, const HapticOutput& output, const Vec3& finger, const Tick& tick,
            double took) noexcept {
    proxy.updates.add(tick.time, 1e6 * took);
    proxy.ladder(tick.time, took);
    ProxyTelemetry& telemetry = proxy.telemetry;
    telemetry.output = output;
    telemetry.finger = finger;
    ++telemetry.updates;
    if (telemetry.worldRevision != proxy.world->revision) telemetry.worldSince = telemetry.updates;
    telemetry.worldRevision = proxy.world->revision;
    telemetry.rate = proxy.updates.rate();
    telemetry.updateMicros = proxy.updates.mean();
    telemetry.worstUpdateMicros = proxy.updates.worst();
    telemetry.boundHits += output.report.boundHit;
    telemetry.squeezed += output.report.squeezed;
    telemetry.passed += output.report.passed;
    telemetry.time = proxy.state.time;
    if (proxy.world->moving) telemetry.bodies = proxy.state.bodies;
    telemetry.coupling = proxy.state.press.coupling;
    telemetry.fidelity = proxy.ladder.fidelity();
    telemetry.stepsDown = proxy.ladder.stepsDown();
    proxy.channels.proxyTelemetry.write(telemetry);
}

// While the loop slept the caches forgot the mesh. Where there is time the step is gone through beforehand,
// hand by hand, with each finger where it is if it went on as it did. Only then are the fingers read: what
// they did meanwhile is in the step, and from reading to force it is short.
void rehearseStep(Proxy& proxy, const Tick& tick, double period) noexcept {
    for (std::size_t i = 0; i < proxy.channels.hands(); ++i) {
        const double spent = proxy.took + 1e-9 * double(monotonicNanoseconds() - tick.woke);
        if (spent > kRehearsed * period) return;
        const FingerSample& finger = proxy.fingers[i];
        if (!finger.valid) continue;
        const HapticInput next{.finger = finger.position + period * finger.velocity,
                               .fingerVelocity = finger.velocity,
                               .fidelity = proxy.ladder.fidelity()};
        rehearse(*proxy.world, stateOf(proxy, i), proxy.state.time, next, period, proxy.rehearsed);
    }
}

} // namespace

void proxyLoop(Channels& channels, double rate, double budget) noexcept {
    Proxy proxy{.channels = channels,
                .ladder = DegradationController(budget),
                .others = std::vector<HandState>(channels.others.size()),
                .begun = channels.recorder.now()};
    Fingers& fingers = proxy.fingers;
    Metronome metronome(rate, kProxyRest);
    while (!channels.stop.load(std::memory_order_relaxed)) {
        const Tick tick = metronome.wait();

        const RealtimeScope scope;
        takeWorld(proxy);
        obeyCommands(proxy);
        if (proxy.world) rehearseStep(proxy, tick, metronome.period());
        if (!takeFingers(channels, fingers) || !proxy.world) {
            proxy.updates.begin(tick.time);
            continue;
        }

        const std::int64_t begun = monotonicNanoseconds();
        const PerHand<HapticOutput> outputs = step(proxy, fingers, tick);
        publishModels(proxy, outputs);
        reportOthers(proxy, outputs, fingers);
        proxy.took = 1e-9 * double(monotonicNanoseconds() - begun);
        report(proxy, outputs[0], fingers[0].position, tick, proxy.took);
    }
}

} // namespace tactum
