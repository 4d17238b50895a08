// Runs devices against a World: owns a servo thread for each, the proxy thread and the channels between them.
#pragma once

#include "core/runtime/engine.h"

namespace tactum {

/// As an Engine it speaks of one of its hands, the first until speakOf(); hand(i) is each of them. All touch
/// one World, and a haptic step is one of all. A fault, or forces off, is of one hand: the others go on.
class LocalEngine final : public Engine {
public:
    explicit LocalEngine(std::unique_ptr<HapticDevice> device);
    ~LocalEngine() override;

    class Hand;
    /// From 1 to kMaxHands.
    std::size_t hands() const;
    /// i < hands().
    Hand hand(std::size_t i);
    /// The hand, below hands(), that the members of Engine are about from now on; the first again when it is
    /// removed. What it traced before is dropped.
    void speakOf(std::size_t hand);
    std::size_t spokenOf() const;
    /// One more hand, with its device. Loops that ran stop and start again, forces off. Refuses more than
    /// kMaxHands, and then nothing changes. On another error nothing runs, and start() would try again with
    /// it.
    Result<void> addDevice(std::unique_ptr<HapticDevice> device);
    /// Another device for one hand, below hands(), as setDevice() for the one it speaks of.
    Result<void> exchangeDevice(std::size_t hand, std::unique_ptr<HapticDevice> device);
    /// Without this hand, below hands(), whose device is destroyed; those after it move up. Loops that ran
    /// start again, forces off. The last one stays.
    Result<void> removeDevice(std::size_t hand);
    /// Forces of all hands on or off.
    void setAllArmed(bool armed);
    bool anyArmed() const;

    Result<void> start() override;
    Result<void> stop() override;
    bool running() const override;
    Result<void> setDevice(std::unique_ptr<HapticDevice> device) override;
    std::string trouble() const override;
    std::string caution() const override;
    Result<void> setWorkspace(const Workspace& workspace) override;
    const Workspace& workspace() const override;
    void publish(std::shared_ptr<const World> world) override;
    std::uint64_t publishedAfter() const override;
    void setArmed(bool armed) override;
    void fade() override;
    bool armed() const override;
    void setDeadMan(bool on) override;
    bool deadMan() const override;
    void setOverrideCeiling(bool on) override;
    bool overridesCeiling() const override;
    void push(const Vec3& force) override;
    void setGrasped(bool on) override;
    void restartProxy() override;
    void setPace(double pace) override;
    double pace() const override;
    void beginBodies() override;
    void stepBodies() override;
    void poll() override;
    const ProxyTelemetry& proxy() const override;
    const ServoTelemetry& servo() const override;
    bool servoStandsStill() const override;
    bool popTrace(TracePoint& point) override;
    RecordedRun recorded() const override;
    const DeviceInfo& device() const override;
    bool hasRealtimePriority() const override;
    const std::string& priorityNote() const override;

private:
    void abandon();

    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// One hand: each member as the one of Engine. A view, until the engine's devices change or it
/// stops. Thread: that of the engine's members.
class LocalEngine::Hand {
public:
    const DeviceInfo& device() const;
    std::string trouble() const;
    std::string caution() const;
    Result<void> setWorkspace(const Workspace& workspace);
    const Workspace& workspace() const;
    void setArmed(bool armed);
    void fade();
    bool armed() const;
    void setDeadMan(bool on);
    bool deadMan() const;
    void setOverrideCeiling(bool on);
    bool overridesCeiling() const;
    void push(const Vec3& force);
    void setGrasped(bool on);
    void restartProxy();
    /// What it touches, as poll() found it.
    const TouchTelemetry& touch() const;
    const ServoTelemetry& servo() const;
    bool servoStandsStill() const;
    bool popTrace(TracePoint& point);

private:
    friend class LocalEngine;
    Hand(Impl& engine, std::size_t index) : engine_(engine), index_(index) {}

    Impl& engine_;
    std::size_t index_;
};

} // namespace tactum
