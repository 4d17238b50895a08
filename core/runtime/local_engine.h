// Runs a device against a World: owns the servo and the proxy thread and the channels between them.
#pragma once

#include "core/runtime/engine.h"

namespace tactum {

class LocalEngine final : public Engine {
public:
    explicit LocalEngine(std::unique_ptr<HapticDevice> device);
    ~LocalEngine() override;

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

} // namespace tactum
