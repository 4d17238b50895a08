#include "core/runtime/engine_report.h"

#include <algorithm>

#include "core/base/byte_stream.h"
#include "core/base/text.h"
#include "core/port/device_figures.h"
#include "core/runtime/local_engine.h"

namespace tactum {
namespace {

/// Another one with every change of a member below: who reads an older one would misread it.
constexpr std::uint32_t kVersion = 5;
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

template <class Io> void bytes(Io& io, TouchTelemetry& touch) {
    auto& [output, finger, coupling] = touch;
    bytes(io, output), io(finger);
}

template <class Io> void bytes(Io& io, WorldTelemetry& world) {
    auto& [updates, worldRevision, worldSince, rate, updateMicros, worstUpdateMicros, boundHits, squeezed,
           passed, time, bodies, fidelity, stepsDown] = world;
    io(updates), io(worldRevision), io(worldSince), io(rate), io(updateMicros);
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
    io(periods.longest);
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

template <class Io> void bytes(Io& io, HandReport& hand) {
    auto& [device, standsStill, armed, deadMan, overridesCeiling, workspace, trouble, caution, touch, servo,
           trace] = hand;
    bytes(io, device), bytes(io, workspace);
    io(standsStill), io(armed), io(deadMan), io(overridesCeiling);
    sentence(io, trouble), sentence(io, caution);
    bytes(io, touch), bytes(io, servo);
    io.count(trace, 100);
    for (TracePoint& point : trace)
        bytes(io, point);
}

template <class Io> void bytes(Io& io, EngineReport& report) {
    auto& [running, realtime, pace, publishedAfter, priorityNote, world, hands] = report;
    std::uint32_t version = kVersion;
    io(version);
    io.demand(version == kVersion, "the server is of another version of Tactum");
    io(running), io(realtime), io(pace), io(publishedAfter);
    sentence(io, priorityNote);
    bytes(io, world);
    io.count(hands, 100);
    io.demand(!hands.empty() && hands.size() <= std::size_t(kMaxHands), "there are more hands than can be");
    for (HandReport& hand : hands)
        bytes(io, hand);
}

void report(LocalEngine::Hand hand, HandReport& to) {
    to.device = hand.device();
    to.standsStill = hand.servoStandsStill(), to.armed = hand.armed(), to.deadMan = hand.deadMan();
    to.overridesCeiling = hand.overridesCeiling();
    to.workspace = hand.workspace();
    to.trouble = hand.trouble(), to.caution = hand.caution();
    to.touch = hand.touch(), to.servo = hand.servo();
    to.trace.clear();
    for (TracePoint point; hand.popTrace(point);)
        to.trace.push_back(point);
}

} // namespace

void report(LocalEngine& engine, EngineReport& to) {
    to.running = engine.running(), to.realtime = engine.hasRealtimePriority();
    to.pace = engine.pace();
    to.publishedAfter = engine.publishedAfter();
    to.priorityNote = engine.priorityNote();
    to.world = engine.proxy();
    to.hands.resize(engine.hands());
    for (std::size_t hand = 0; hand < to.hands.size(); ++hand)
        report(engine.hand(hand), to.hands[hand]);
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
