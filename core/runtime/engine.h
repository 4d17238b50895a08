// What drives a device against a World, as whoever shows and edits the scene sees it: its loops are here
// (LocalEngine) or at a haptic server (RemoteEngine in core/protocol).
#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/haptics/world.h"
#include "core/port/haptic_device.h"
#include "core/runtime/channels.h"

namespace tactum {

/// The proxy is updated this many times for each servo tick, where its work allows.
inline constexpr double kUpdatesPerTick = 2;

class Engine {
public:
    // Thread of every member: one at a time, not real time (the ui thread in the program).

    Engine() = default;
    virtual ~Engine() = default;
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    /// Opens the device and starts both loops, forces off. Refuses a device whose figures cannot be.
    virtual Result<void> start() = 0;
    /// Zero force, both loops ended, device closed. Safe to call twice. The newest World stays for a later
    /// start(); all others are released. A device that does not come back from its exchange within a second
    /// is stopped the short way and given up with all that its servo may still touch, which is the error:
    /// start() then refuses it, setDevice() takes another one.
    virtual Result<void> stop() = 0;
    virtual bool running() const = 0;

    /// Another device instead, prepared already: stops, and starts with it, forces off. The old one is
    /// destroyed. On an error nothing runs, and the new device is the one that start() would try again.
    virtual Result<void> setDevice(std::unique_ptr<HapticDevice> device) = 0;
    /// Why the device sends no readings that can be used, with what to do; empty while all is well.
    virtual std::string trouble() const = 0;
    /// What the device lacks of its own safety, with what to do; empty when nothing.
    virtual std::string caution() const = 0;

    /// Where the device's workspace is in the scene, from the next tick on; the proxy begins at the finger
    /// anew where that moves it. Stays so through stop(), start() and setDevice(). Refuses what cannot be.
    virtual Result<void> setWorkspace(const Workspace& workspace) = 0;
    /// As it was decided; ServoTelemetry::frame says where clutch and bump have moved it.
    virtual const Workspace& workspace() const = 0;

    /// Hands over a World; the proxy loop takes it at its next update. The old one is destroyed here, at a
    /// later publish() or poll(), never on a loop. Starting without a World is fine: nothing is touched; a
    /// null pointer is ignored.
    virtual void publish(std::shared_ptr<const World> world) = 0;
    /// How many updates were done when the last World was handed over. It is felt from the update
    /// ProxyTelemetry::worldSince on: the next one, or the one after that which is under way.
    virtual std::uint64_t publishedAfter() const = 0;
    /// Forces on or off. Off is also the state after start(). On, the force comes gently
    /// (kRise): a finger that is deep inside is not thrown out. After a fault they stay off until they were
    /// switched off and on again.
    virtual void setArmed(bool armed) = 0;
    /// Forces off, over kFadeAway instead of at once: for when nobody is there who could have wanted it.
    virtual void fade() = 0;
    virtual bool armed() const = 0;
    /// Force only while one of the device's buttons is held: a dead-man switch. Stays so through stop() and
    /// start(). Without effect on a device that has no buttons: it would never push.
    virtual void setDeadMan(bool on) = 0;
    /// Whether it is asked for and the device has a button.
    virtual bool deadMan() const = 0;
    /// Surfaces may be stiffer than safeStiffness(), at the person's own risk. Off after start().
    virtual void setOverrideCeiling(bool on) = 0;
    virtual bool overridesCeiling() const = 0;
    /// Adds a force to what the finger feels, N, world frame, from the next tick on: under the device's
    /// limit, the gate and kOutsidePower. Said again within kOutsidePatience, or it fades.
    virtual void push(const Vec3& force) = 0;
    /// Whether the whole hand holds the device and not two fingers, as the person says: it bears stiffer
    /// surfaces, from the next contact on. Stays so through stop() and start(), not with another device.
    virtual void setGrasped(bool on) = 0;
    /// Puts the proxy onto the finger: a new model, a jump of the hand.
    virtual void restartProxy() = 0;
    /// How fast the bodies' time goes, from 0 (they stand still) to 1. Stays so through stop() and start().
    virtual void setPace(double pace) = 0;
    virtual double pace() const = 0;
    /// Puts all bodies that move to where they began.
    virtual void beginBodies() = 0;
    /// Lets them go on for one step of the proxy loop: while they stand still.
    virtual void stepBodies() = 0;

    /// Collects the newest telemetry and drops retired Worlds. Call it once a frame.
    virtual void poll() = 0;
    virtual const ProxyTelemetry& proxy() const = 0;
    virtual const ServoTelemetry& servo() const = 0;
    /// Whether no tick came for half a second, as far as poll() looked: a device that does not come back from
    /// its exchange. The rate is 0 then.
    virtual bool servoStandsStill() const = 0;
    /// Takes the next tick for the plots; false when there is none.
    virtual bool popTrace(TracePoint& point) = 0;

    /// The last minute since start(), with the scenes that were felt in it. Steps again bit for bit. Costs
    /// tens of milliseconds and some tens of megabytes; the loops do not notice.
    virtual RecordedRun recorded() const = 0;

    virtual const DeviceInfo& device() const = 0;
    /// True when both loops have a real-time priority, not necessarily the one they ask for, and locked
    /// memory.
    virtual bool hasRealtimePriority() const = 0;
    /// One sentence about priority for the status bar: what was granted, or why not and what helps.
    virtual const std::string& priorityNote() const = 0;
};

} // namespace tactum
