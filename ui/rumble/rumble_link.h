// From the ticks of the servo to a gamepad.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QObject>

#include "core/runtime/trace_point.h"
#include "ui/rumble/pads.h"

namespace tactum {

/// Off at first. Thread: ui; neither it nor a loop ever waits for a gamepad.
class RumbleLink : public QObject {
    Q_OBJECT
public:
    explicit RumbleLink(QObject* parent = nullptr);
    ~RumbleLink() override;

    bool on() const { return pads_ != nullptr; }
    /// Off, every motor stands still before it returns.
    void setOn(bool on);
    /// As PadMotors takes it.
    void setStrength(double strength) { strength_ = strength; }
    /// By its key; an empty one, or one that is not there, is the first that came.
    void choose(const std::string& key);
    const std::string& chosen() const { return chosen_; }
    /// While nobody attends nothing vibrates.
    void setAttended(bool attended);

    /// All that vibrate; none while it is off, or before it has looked.
    const std::vector<Pad>& pads() const { return found_; }
    /// The one that plays.
    std::optional<Pad> used() const;

    /// What the servo did since the last call, `rate` times a second; nothing happens while it is off.
    void play(const std::vector<TracePoint>& points, double rate);

signals:
    /// It has looked, or pads came or went.
    void padsChanged();

private:
    void take(std::vector<Pad> found);

    std::unique_ptr<Pads> pads_;
    int times_ = 0; ///< that it was switched on or off: what pads of before still say is old
    std::vector<Pad> found_;
    std::string chosen_;
    double strength_ = 1;
    bool attended_ = true;
    double rate_ = 1000; ///< Hz
    PadMotors motors_;
};

} // namespace tactum
