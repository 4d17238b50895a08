#include "core/runtime/engine_report.h"

#include <algorithm>

#include "core/base/byte_stream.h"
#include "core/base/text.h"
#include "core/port/device_figures.h"

namespace tactum {
namespace {

/// Another one with every change of a member below: who reads an older one would misread it.
constexpr std::uint32_t kVersion = 3;
constexpr std::size_t kLongestSentence = 1000;

// Each function names all members of its struct: one more there does not compile here until it has its line.

template <class Io> void sentence(Io& io, std::string& text) {
    io(text);
    if constexpr (Io::kReads) text = printable(text, kLongestSentence);
}

template <class Io> void bytes(Io& io, AxisMap& axes) {
    for (auto& axis : axes) {
        io(axis);
        io.demand(axis != 0 && axis >= -3 && axis <= 3, "an axis is none of three");
    }
}

template <class Io> void bytes(Io& io, DeviceFrame& frame) {
    auto& [scale, axes, offset] = frame;
    io(scale), bytes(io, axes), io(offset);
}

template <class Io> void bytes(Io& io, Workspace& workspace) {
    auto& [scale, axes, offset, clutch, bump, reach, centring] = workspace;
    io(scale), bytes(io, axes), io(offset), io(clutch), io(bump), io(centring);
    choose(io, reach.mode, kReachModes), io(reach.shell);
}

template <class Io> void bytes(Io& io, DeviceInfo& device) {
    sentence(io, device.name);
    for (const DeviceFigure& figure : kDeviceFigures)
        io(device.*figure.value);
    io(device.buttons), io(device.real), io(device.measuresVelocity);
}

template <class Io> void bytes(Io& io, StiffnessCeiling& ceiling) {
    auto& [value, reason, damping] = ceiling;
    io(value), io(damping);
    choose(io, reason, kCeilingReasons);
}

template <class Io> void bytes(Io& io, ContactReport& contact) {
    auto& [point, normal, normalForce, body, surface, slipping, frictionless, staticFriction,
           dynamicFriction] = contact;
    io(point), io(normal), io(normalForce), io(body), io(surface), io(slipping), io(frictionless);
    io(staticFriction), io(dynamicFriction);
}

template <class Io> void bytes(Io& io, HapticOutput& output) {
    auto& [proxy, force, contacts, contact, step] = output;
    auto& [rounds, boundHit, squeezed, passed] = step;
    io(proxy), io(force), io(contacts);
    io.demand(contacts >= 0 && contacts <= kMaxModelPlanes, "there are more contacts than can be");
    for (int i = 0; i < contacts; ++i)
        bytes(io, contact[std::size_t(i)]);
    io(rounds), io(boundHit), io(squeezed), io(passed);
}

/// For the picture: where they are and how fast.
template <class Io> void bytes(Io& io, BodiesState& bodies) {
    const auto numbers = [&](int& count, auto& values) {
        io(count);
        io.demand(count >= 0 && std::size_t(count) <= values.size(), "there are more joints than can be");
        for (int i = 0; i < count; ++i)
            io(values[std::size_t(i)]);
    };
    io(bodies.of);
    numbers(bodies.qs, bodies.q), numbers(bodies.vs, bodies.v);
}

template <class Io> void bytes(Io& io, ProxyTelemetry& proxy) {
    auto& [output, finger, coupling] = static_cast<TouchTelemetry&>(proxy);
    auto& [updates, worldRevision, worldSince, rate, updateMicros, worstUpdateMicros, boundHits, squeezed,
           passed, time, bodies, fidelity, stepsDown] = static_cast<WorldTelemetry&>(proxy);
    bytes(io, output);
    io(finger), io(updates), io(worldRevision), io(worldSince), io(rate), io(updateMicros);
    io(worstUpdateMicros), io(boundHits), io(squeezed), io(passed), io(time), io(stepsDown);
    bytes(io, bodies);
    choose(io, fidelity, std::size_t(kMinFidelity) + 1);
}

template <class Io> void bytes(Io& io, ServoTelemetry& servo) {
    auto& [finger, force, handle, frame, border, buttons, ticks, rate, jitter, misses, machineMisses, periods,
           clamped, invalid, inhibit, gain, faults, pauses, lastPause, oscillations, stiffnessScale, heat,
           energy, passivityDamping, rendered, grasped, doubted, ceiling] = servo;
    io(finger), io(force), io(handle), bytes(io, frame), io(border), io(buttons), io(ticks), io(rate),
        io(jitter);
    io(misses), io(machineMisses);
    for (std::uint32_t& count : periods.count)
        io(count);
    io(clamped), io(invalid), io(gain), io(faults), io(pauses), io(oscillations), io(stiffnessScale);
    choose(io, inhibit, kInhibitReasons), choose(io, lastPause, kInhibitReasons);
    io(heat), io(energy), io(passivityDamping), io(rendered), io(grasped), io(doubted);
    bytes(io, ceiling);
}

template <class Io> void bytes(Io& io, TracePoint& point) {
    auto& [t, finger, proxy, force, wanted, energy, touching, normalForce, tangentialForce, gain, limited,
           revision, touched] = point;
    auto& [contacts, object, surface, friction] = touched;
    io(t), io(finger), io(proxy), io(force), io(wanted), io(energy), io(touching), io(normalForce);
    io(tangentialForce), io(gain), io(limited), io(revision), io(contacts), io(object), io(surface);
    io.demand(contacts >= 0 && contacts <= kMaxModelPlanes, "there are more contacts than can be");
    choose(io, friction, kContactFrictions);
}

template <class Io> void bytes(Io& io, EngineReport& report) {
    auto& [device, running, standsStill, realtime, armed, deadMan, overridesCeiling, pace, workspace,
           publishedAfter, trouble, caution, priorityNote, proxy, servo, trace] = report;
    std::uint32_t version = kVersion;
    io(version);
    io.demand(version == kVersion, "the server is of another version of Tactum");
    bytes(io, device), bytes(io, workspace);
    io(running), io(standsStill), io(realtime), io(armed), io(deadMan), io(overridesCeiling), io(pace);
    io(publishedAfter);
    sentence(io, trouble), sentence(io, caution), sentence(io, priorityNote);
    bytes(io, proxy), bytes(io, servo);
    io.count(trace, 100);
    for (TracePoint& point : trace)
        bytes(io, point);
}

} // namespace

void report(Engine& engine, EngineReport& to) {
    to.device = engine.device();
    to.running = engine.running(), to.standsStill = engine.servoStandsStill();
    to.realtime = engine.hasRealtimePriority();
    to.armed = engine.armed(), to.deadMan = engine.deadMan(), to.overridesCeiling = engine.overridesCeiling();
    to.pace = engine.pace();
    to.workspace = engine.workspace();
    to.publishedAfter = engine.publishedAfter();
    to.trouble = engine.trouble(), to.caution = engine.caution(), to.priorityNote = engine.priorityNote();
    to.proxy = engine.proxy(), to.servo = engine.servo();
    to.trace.clear();
    for (TracePoint point; engine.popTrace(point);)
        to.trace.push_back(point);
}

std::string bytesOf(const EngineReport& report) {
    StringOut out;
    bytes(out, const_cast<EngineReport&>(report)); // writing does not touch it
    return std::move(out.bytes);
}

Result<EngineReport> readReport(std::string_view from) {
    try {
        ByteIn in(from, "what the server tells", 0, "use the same version of Tactum on both sides");
        EngineReport report;
        bytes(in, report);
        in.demand(in.left() == 0, "it is followed by something else");
        return report;
    } catch (const ByteFault& fault) {
        return tl::unexpected(fault.error);
    }
}

} // namespace tactum
