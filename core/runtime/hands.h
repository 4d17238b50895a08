// Each hand of an engine, for whom the one that it speaks of is not enough.
#pragma once

#include "core/runtime/engine.h"

namespace tactum {

class HandsElsewhere;
class LocalEngine;

/// A view of an engine, which outlives it. Where the loops are at a server its hands are those of the server,
/// of which none can be added or taken away here. Hands are numbered from 0; one that is removed lets those
/// after it move up. Thread: that of the engine's members.
class Hands {
public:
    explicit Hands(Engine& engine);

    std::size_t count() const;
    /// Whether there may be one more.
    bool mayAdd() const;
    /// The hand that the engine speaks of.
    std::size_t chosen() const;
    void choose(std::size_t hand);

    // As of LocalEngine: all loops stop and start, forces off.
    Result<void> add(std::unique_ptr<HapticDevice> device);
    Result<void> exchange(std::size_t hand, std::unique_ptr<HapticDevice> device);
    Result<void> remove(std::size_t hand);

    // As of Engine; `hand` < count().
    const DeviceInfo& device(std::size_t hand) const;
    std::string trouble(std::size_t hand) const;
    const TouchTelemetry& touch(std::size_t hand) const;
    const ServoTelemetry& servo(std::size_t hand) const;
    bool servoStandsStill(std::size_t hand) const;
    Result<void> setWorkspace(std::size_t hand, const Workspace& workspace);
    void setGrasped(std::size_t hand, bool on);
    void restartProxy(std::size_t hand);
    void setArmed(std::size_t hand, bool armed);
    bool armed(std::size_t hand) const;

    // Of all of them.
    void setAllArmed(bool armed);
    bool anyArmed() const;
    void setDeadMan(bool on);

private:
    Engine& engine_;
    LocalEngine* local_;
    HandsElsewhere* elsewhere_; ///< where the loops are at a server, and local_ is null
};

} // namespace tactum
