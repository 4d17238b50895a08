// From the ticks of the servo to the loudspeaker.
#pragma once

#include <vector>

#include <QObject>

#include "core/runtime/trace_point.h"
#include "ui/sound/contact_sound.h"
#include "ui/sound/sound_output.h"

namespace tactum {

/// Off at first. Thread: ui; neither it nor a loop ever waits for the sound.
class SoundLink : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    /// Why nothing can be heard on this machine; empty when it can.
    static QString whyNot() { return SoundOutput::whyNot(); }
    /// False when the output does not open.
    bool start();
    void stop() { output_.stop(); }
    /// What the servo did since the last call, `rate` times a second; nothing happens while it is off.
    void play(const std::vector<TracePoint>& points, double rate);

private:
    double rate_ = 1000; ///< Hz
    ContactSound sound_;
    SoundOutput output_;
    std::vector<Vec3> forces_;
};

} // namespace tactum
