// The hands of an engine whose loops are elsewhere.
#pragma once

#include "core/runtime/engine_report.h"

namespace tactum {

/// Each by its number, from 0 and below hands(). What there is no member for is asked of the engine, which
/// speaks of one of them. Thread: that of the engine's members.
class HandsElsewhere {
public:
    virtual ~HandsElsewhere() = default;

    /// As many as there are there; another number where the engine finds others.
    virtual std::size_t hands() const = 0;
    /// As of LocalEngine.
    virtual void speakOf(std::size_t hand) = 0;
    virtual std::size_t spokenOf() const = 0;
    /// What was told of it when the engine was polled, and what was ordered since.
    virtual const HandReport& told(std::size_t hand) const = 0;

    // As of Engine, of one hand.
    virtual Result<void> setWorkspaceOf(std::size_t hand, const Workspace& workspace) = 0;
    virtual void setGraspedOf(std::size_t hand, bool on) = 0;
    virtual void restartProxyOf(std::size_t hand) = 0;
    virtual void setArmedOf(std::size_t hand, bool armed) = 0;
    /// All of them, now.
    virtual void setAllArmed(bool armed) = 0;
};

} // namespace tactum
