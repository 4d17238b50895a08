// Follows what the force gate and the degradation controller do, frame by frame, and keeps the last events.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include <QElapsedTimer>
#include <QObject>
#include <QTime>

#include "core/runtime/hands.h"
#include "ui/engine/steady_ceiling.h"

namespace tactum {

/// Something that took force or fidelity away.
struct HealthEvent {
    QTime time;
    bool fault = false;
    QString what;      ///< one sentence
    QString sentences; ///< with what was done about it and how to go on
};

/// Switches the forces of a hand off with every fault of it, so that they come back only when a person arms
/// anew. What else it follows is of the hand that the engine speaks of. Thread: ui.
class GuardWatch : public QObject {
    Q_OBJECT
public:
    explicit GuardWatch(Engine& engine, QObject* parent = nullptr);

    /// Once a frame, after Engine::poll().
    void frame();
    /// Forces of all hands on or off, by a person. On ends the faults.
    void setArmed(bool armed);
    /// The engine has other devices.
    void forget();
    /// The stiffness ceiling, without the machine's jitter.
    const CeilingNow& ceiling() const { return ceiling_.shown(); }
    /// Whose fault it is, of several the first; nothing when all is well. Until the person arms anew.
    std::optional<std::size_t> faultyHand() const;
    std::optional<InhibitReason> fault() const;
    /// What is said of it; of several hands with the name of the device.
    QString faultSentences() const;
    /// Why there is less force than usual, or less fidelity; empty when all is well.
    QString quietNote() const;
    /// Newest first.
    const std::deque<HealthEvent>& events() const { return events_; }

signals:
    void faulted(tactum::InhibitReason why);
    void happened();

private:
    void begin();
    QString namedOf(std::size_t hand, const QString& words) const;
    void watchFault(std::size_t hand);
    void watchPauses();
    void watchHeat(const ServoTelemetry& servo);
    void watchProxy();
    void watchCeiling();
    void add(bool fault, const QString& what, const QString& sentences);

    Engine& engine_;
    Hands hands_;
    std::vector<std::optional<InhibitReason>> faults_; ///< of each hand
    std::size_t watched_ = 0;                          ///< the hand that the counters are of
    std::uint64_t unread_ = 0, pauses_ = 0, oscillations_ = 0, stepsDown_ = 0;
    bool standsStill_ = false;
    bool warned_ = false; ///< that the motors are getting warm
    SteadyCeiling ceiling_;
    QString moved_; ///< what was last said of it
    QElapsedTimer clock_, sincePause_, sinceUnread_, sinceWarm_, sinceMoved_;
    std::deque<HealthEvent> events_;
};

} // namespace tactum
