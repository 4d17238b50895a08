// Follows what the force gate and the degradation controller do, frame by frame, and keeps the last events.
#pragma once

#include <deque>
#include <optional>

#include <QElapsedTimer>
#include <QObject>
#include <QTime>

#include "core/runtime/engine.h"
#include "ui/engine/steady_ceiling.h"

namespace tactum {

/// Something that took force or fidelity away.
struct HealthEvent {
    QTime time;
    bool fault = false;
    QString what;      ///< one sentence
    QString sentences; ///< with what was done about it and how to go on
};

/// Switches the forces off with every fault, so that they come back only when a person arms anew.
/// Thread: ui.
class GuardWatch : public QObject {
    Q_OBJECT
public:
    explicit GuardWatch(Engine& engine, QObject* parent = nullptr);

    /// Once a frame, after Engine::poll().
    void frame();
    /// Forces on or off, by a person. On ends the fault.
    void setArmed(bool armed);
    /// The device that had the fault is not the engine's any more.
    void forget() {
        fault_.reset();
        ceiling_.forget();
    }
    /// The stiffness ceiling, without the machine's jitter.
    const CeilingNow& ceiling() const { return ceiling_.shown(); }
    /// Until the person arms anew.
    std::optional<InhibitReason> fault() const { return fault_; }
    /// Why there is less force than usual, or less fidelity; empty when all is well.
    QString quietNote() const;
    /// Newest first.
    const std::deque<HealthEvent>& events() const { return events_; }

signals:
    void faulted(tactum::InhibitReason why);
    void happened();

private:
    void watchFault();
    void watchPauses();
    void watchHeat(const ServoTelemetry& servo);
    void watchProxy();
    void watchCeiling();
    void add(bool fault, const QString& what, const QString& sentences);

    Engine& engine_;
    std::optional<InhibitReason> fault_;
    std::uint64_t unread_ = 0, pauses_ = 0, oscillations_ = 0, stepsDown_ = 0;
    bool standsStill_ = false;
    bool warned_ = false; ///< that the motors are getting warm
    SteadyCeiling ceiling_;
    QString moved_; ///< what was last said of it
    QElapsedTimer clock_, sincePause_, sinceUnread_, sinceWarm_, sinceMoved_;
    std::deque<HealthEvent> events_;
};

} // namespace tactum
