// Runs a device against a World: owns the servo and the proxy thread and the channels between them.
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
    /// Thread of every member: one at a time, not real time (the ui thread in the program).
    explicit Engine(std::unique_ptr<HapticDevice> device);
    ~Engine();
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    /// Opens the device and starts both loops, forces off. Refuses a device whose figures cannot be.
    Result<void> start();
    /// Zero force, both loops ended, device closed. Safe to call twice. The newest World stays for a later
    /// start(); all others are released. A device that does not come back from its exchange within a second
    /// is stopped the short way and given up with all that its servo may still touch, which is the error:
    /// start() then refuses it, setDevice() takes another one.
    Result<void> stop();
    bool running() const;

    /// Another device instead, prepared already: stops, and starts with it, forces off. The old one is
    /// destroyed. On an error nothing runs, and the new device is the one that start() would try again.
    Result<void> setDevice(std::unique_ptr<HapticDevice> device);
    /// Why the device sends no readings that can be used, with what to do; empty while all is well.
    std::string trouble() const;
    /// What the device lacks of its own safety, with what to do; empty when nothing.
    std::string caution() const;

    /// Where the device's workspace is in the scene, from the next tick on; the proxy begins at the finger
    /// anew where that moves it. Stays so through stop(), start() and setDevice(). Refuses what cannot be.
    Result<void> setWorkspace(const Workspace& workspace);
    /// As it was decided; ServoTelemetry::frame says where clutch and bump have moved it.
    const Workspace& workspace() const;

    /// Hands over a World; the proxy loop takes it at its next update. The old one is destroyed here, at a
    /// later publish() or poll(), never on a loop. Starting without a World is fine: nothing is touched; a
    /// null pointer is ignored.
    void publish(std::shared_ptr<const World> world);
    /// How many updates were done when the last World was handed over. It is felt from the update
    /// ProxyTelemetry::worldSince on: the next one, or the one after that which is under way.
    std::uint64_t publishedAfter() const;
    /// Forces on or off. Off is also the state after start(). On, the force comes gently
    /// (kRise): a finger that is deep inside is not thrown out. After a fault they stay off until they were
    /// switched off and on again.
    void setArmed(bool armed);
    /// Forces off, over kFadeAway instead of at once: for when nobody is there who could have wanted it.
    void fade();
    bool armed() const;
    /// Force only while one of the device's buttons is held: a dead-man switch. Stays so through stop() and
    /// start(). Without effect on a device that has no buttons: it would never push.
    void setDeadMan(bool on);
    /// Whether it is asked for and the device has a button.
    bool deadMan() const;
    /// Surfaces may be stiffer than safeStiffness(), at the person's own risk. Off after start().
    void setOverrideCeiling(bool on);
    bool overridesCeiling() const;
    /// Adds a force to what the finger feels, N, world frame, from the next tick on: under the device's
    /// limit, the gate and kOutsidePower. Said again within kOutsidePatience, or it fades.
    void push(const Vec3& force);
    /// Whether the whole hand holds the device and not two fingers, as the person says: it bears stiffer
    /// surfaces, from the next contact on. Stays so through stop() and start(), not with another device.
    void setGrasped(bool on);
    /// Puts the proxy onto the finger: a new model, a jump of the hand.
    void restartProxy();
    /// How fast the bodies' time goes, from 0 (they stand still) to 1. Stays so through stop() and start().
    void setPace(double pace);
    double pace() const;
    /// Puts all bodies that move to where they began.
    void beginBodies();
    /// Lets them go on for one step of the proxy loop: while they stand still.
    void stepBodies();

    /// Collects the newest telemetry and drops retired Worlds. Call it once a frame.
    void poll();
    const ProxyTelemetry& proxy() const;
    const ServoTelemetry& servo() const;
    /// Whether no tick came for half a second, as far as poll() looked: a device that does not come back from
    /// its exchange. The rate is 0 then.
    bool servoStandsStill() const;
    /// Takes the next tick for the plots; false when there is none.
    bool popTrace(TracePoint& point);

    /// The last minute since start(), with the scenes that were felt in it. Steps again bit for bit. Costs
    /// tens of milliseconds and some tens of megabytes; the loops do not notice.
    RecordedRun recorded() const;

    const DeviceInfo& device() const;
    /// True when both loops have a real-time priority, not necessarily the one they ask for, and locked
    /// memory.
    bool hasRealtimePriority() const;
    /// One sentence about priority for the status bar: what was granted, or why not and what helps.
    const std::string& priorityNote() const;

private:
    void abandon();

    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace tactum
