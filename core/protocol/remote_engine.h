// An engine whose loops are at a haptic server: the window is a client like every other.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/port/hand_target.h"
#include "core/protocol/remote_settings.h"
#include "core/runtime/engine.h"
#include "core/runtime/hands_elsewhere.h"
#include "core/runtime/shared_scene.h"

namespace tactum {

/// What is ordered goes out at once, beside the caller; what is published goes out whole, the newest as soon
/// as the one before has arrived. What a loop tells is as old as the way from the server. Where the
/// connection is lost it is made again, and what is published is sent anew; the forces stay off until they
/// are switched on. As an Engine it speaks of one of the server's hands, the first until speakOf(); forces
/// off, dead-man switch and pace are for all of them.
class RemoteEngine final : public Engine, public HandsElsewhere, public SharedScene {
public:
    /// `hand`: where the first simulated hand of the server should go, if it has one; may be null.
    RemoteEngine(RemoteSettings settings, std::shared_ptr<HandTarget> hand);
    ~RemoteEngine() override;

    /// Attends. On an error it goes on trying.
    Result<void> start() override;
    /// Leaves; the server's device is let go, its scene stays.
    Result<void> stop() override;
    /// Whether the server is there and was heard of late.
    bool running() const override;
    /// Refused: the device is the server's.
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
    /// Waits for the server. Empty where it does not answer.
    RecordedRun recorded() const override;
    const DeviceInfo& device() const override;
    bool hasRealtimePriority() const override;
    const std::string& priorityNote() const override;

    std::size_t hands() const override;
    void speakOf(std::size_t hand) override;
    std::size_t spokenOf() const override;
    const HandReport& told(std::size_t hand) const override;
    Result<void> setWorkspaceOf(std::size_t hand, const Workspace& workspace) override;
    void setGraspedOf(std::size_t hand, bool on) override;
    /// Without the pen nothing happens.
    void restartProxyOf(std::size_t hand) override;
    /// Off, for who has the pen: a force that a guard ended stays away without that. Who wants it off for
    /// good, with or without the pen, means all.
    void setArmedOf(std::size_t hand, bool armed) override;
    void setAllArmed(bool armed) override;

    std::string place() const override;
    std::optional<Arrived> arrived() override;
    std::optional<std::string> refused() override;
    std::optional<std::string> forceSaid() override;
    bool holdsPen() const override;
    std::string penHolder() const override;
    void askForPen() override;
    std::optional<std::string> penAskedBy() override;
    std::string penAsker() const override;
    void givePen(const std::string& to) override;
    std::size_t attending() const override;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace tactum
