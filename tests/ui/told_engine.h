// An engine that does nothing and tells what a test says of its hands: what the window makes of it is seen
// without loops.
#pragma once

#include "core/runtime/engine.h"
#include "core/runtime/hands_elsewhere.h"

namespace tactum::test {

class ToldEngine final : public Engine, public HandsElsewhere {
public:
    explicit ToldEngine(std::size_t hands = 1) : of(hands) {}

    std::vector<HandReport> of; ///< each hand, as it is told
    ProxyTelemetry proxyTold;
    std::size_t chosen = 0;
    bool runs = true;
    RecordedRun run;                                  ///< that it has recorded
    std::vector<std::shared_ptr<const World>> worlds; ///< that it was given
    std::vector<bool> deadMen, overrides;             ///< each that it was asked for
    std::vector<std::size_t> restarted;               ///< hands whose proxy was put where the finger is

    Result<void> start() override { return {}; }
    Result<void> stop() override { return {}; }
    bool running() const override { return runs; }
    Result<void> setDevice(std::unique_ptr<HapticDevice>) override { return {}; }
    std::string trouble() const override { return of[chosen].trouble; }
    std::string caution() const override { return {}; }
    Result<void> setWorkspace(const Workspace&) override { return {}; }
    const Workspace& workspace() const override { return workspace_; }
    void publish(std::shared_ptr<const World> world) override { worlds.push_back(std::move(world)); }
    std::uint64_t publishedAfter() const override { return 0; }
    void setArmed(bool armed) override { of[chosen].armed = armed; }
    void fade() override { of[chosen].armed = false; }
    bool armed() const override { return of[chosen].armed; }
    void setDeadMan(bool on) override { deadMen.push_back(on); }
    bool deadMan() const override { return !deadMen.empty() && deadMen.back(); }
    void setOverrideCeiling(bool on) override { overrides.push_back(on); }
    bool overridesCeiling() const override { return !overrides.empty() && overrides.back(); }
    void push(const Vec3&) override {}
    void setGrasped(bool) override {}
    void restartProxy() override {}
    void setPace(double) override {}
    double pace() const override { return 1; }
    void beginBodies() override {}
    void stepBodies() override {}
    void poll() override {}
    const ProxyTelemetry& proxy() const override { return proxyTold; }
    const ServoTelemetry& servo() const override { return of[chosen].servo; }
    bool servoStandsStill() const override { return of[chosen].standsStill; }
    bool popTrace(TracePoint&) override { return false; }
    RecordedRun recorded() const override { return run; }
    const DeviceInfo& device() const override { return of[chosen].device; }
    bool hasRealtimePriority() const override { return true; }
    const std::string& priorityNote() const override { return note_; }

    std::size_t hands() const override { return of.size(); }
    void speakOf(std::size_t hand) override { chosen = hand; }
    std::size_t spokenOf() const override { return chosen; }
    const HandReport& told(std::size_t hand) const override { return of[hand]; }
    Result<void> setWorkspaceOf(std::size_t, const Workspace&) override { return {}; }
    void setGraspedOf(std::size_t, bool) override {}
    void restartProxyOf(std::size_t hand) override { restarted.push_back(hand); }
    void setArmedOf(std::size_t hand, bool armed) override { of[hand].armed = armed; }
    void setAllArmed(bool armed) override {
        for (HandReport& each : of)
            each.armed = armed;
    }

private:
    Workspace workspace_;
    std::string note_;
};

} // namespace tactum::test
