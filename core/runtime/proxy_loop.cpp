#include "core/runtime/proxy_loop.h"

#include <algorithm>
#include <utility>

#include "core/base/realtime.h"
#include "core/loop/metronome.h"

namespace tactum {
namespace {

/// What the proxy loop remembers from step to step.
struct Proxy {
    Channels& channels;
    const World* world = nullptr;
    bool restartDue = false;     ///< the next step begins at the finger
    bool beginDue = false;       ///< the next step begins with the bodies where they began
    bool stepDue = false;        ///< the bodies go on in the next step
    std::uint32_t anchoring = 0; ///< of the last finger
    DegradationController ladder;
    SimState state{};
    ProxyState rehearsed{}; ///< thrown away each time
    HalfSecond updates{};
    ProxyTelemetry telemetry{};
    double begun = 0; ///< s, when the metronome was made, on the recorder's clock
};

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

void obeyCommands(Proxy& proxy) noexcept {
    EngineCommand command;
    while (proxy.channels.commands.pop(command)) {
        switch (command.kind) {
        case EngineCommand::Kind::RestartProxy:
            proxy.restartDue = true;
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

HapticOutput step(Proxy& proxy, const FingerSample& finger, const Tick& tick) noexcept {
    const bool restart = proxy.restartDue, found = !restart && finger.anchoring != proxy.anchoring;
    const bool begin = std::exchange(proxy.beginDue, false);
    const bool goesOn = std::exchange(proxy.stepDue, false);
    proxy.restartDue = false;
    proxy.anchoring = finger.anchoring;
    ProxyRow row{.time = proxy.begun + tick.time,
                 .dt = std::clamp(tick.elapsed, kShortestStep, kLongestStep),
                 .pace = goesOn ? 1 : proxy.channels.pace.load(std::memory_order_relaxed),
                 .coupling = {finger.coupling.stiffness, finger.coupling.force, finger.coupling.delay},
                 .finger = tripleOf(finger.position),
                 .velocity = tripleOf(finger.velocity),
                 .world = proxy.world->revision,
                 .anchoring = finger.anchoring,
                 .flags = flagsOf(restart, found, proxy.ladder.fidelity()) |
                          (begin ? std::uint32_t(ProxyRow::Begin) : 0)};
    Recorder& recorder = proxy.channels.recorder;
    recorder.begin(row, proxy.state);
    const HapticOutput output = stepFrom(row, *proxy.world, proxy.state);
    note(row, output);
    recorder.end(row);
    return output;
}

void report(Proxy& proxy, const HapticOutput& output, const Vec3& finger, const Tick& tick,
            double micros) noexcept {
    proxy.updates.add(tick.time, micros);
    proxy.ladder(tick.time, 1e-6 * micros);
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

// Between two steps the caches forget the mesh. Where there is time the next step is gone through beforehand,
// with the finger where it will be then if it goes on as it does.
void rehearseNext(Proxy& proxy, const FingerSample& finger, const Tick& tick, double period) noexcept {
    const double spent = 1e-9 * double(monotonicNanoseconds() - tick.woke);
    if (spent > kRehearsed * period) return;
    const HapticInput next{.finger = finger.position + period * finger.velocity,
                           .fingerVelocity = finger.velocity,
                           .fidelity = proxy.ladder.fidelity()};
    rehearse(*proxy.world, proxy.state, next, period, proxy.rehearsed);
}

} // namespace

void proxyLoop(Channels& channels, double rate, double budget) noexcept {
    Proxy proxy{
        .channels = channels, .ladder = DegradationController(budget), .begun = channels.recorder.now()};
    Metronome metronome(rate, kProxyRest);
    while (!channels.stop.load(std::memory_order_relaxed)) {
        const Tick tick = metronome.wait();

        const RealtimeScope scope;
        takeWorld(proxy);
        obeyCommands(proxy);
        const FingerSample& finger = channels.finger.read();
        if (!proxy.world || !finger.valid) {
            proxy.updates.begin(tick.time);
            continue;
        }

        const std::int64_t begun = monotonicNanoseconds();
        const HapticOutput output = step(proxy, finger, tick);
        channels.contactModel.write({proxy.state.model, channels.recorder.proxyCount()});
        report(proxy, output, finger.position, tick, 1e-3 * double(monotonicNanoseconds() - begun));
        rehearseNext(proxy, finger, tick, metronome.period());
    }
}

} // namespace tactum
