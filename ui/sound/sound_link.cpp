#include "ui/sound/sound_link.h"

namespace tactum {

bool SoundLink::start(double servoRate) {
    sound_ = ContactSound(servoRate);
    return output_.start();
}

void SoundLink::play(const std::vector<TracePoint>& points) {
    if (!output_.playing()) return;
    forces_.clear();
    for (const TracePoint& point : points)
        forces_.push_back(point.force);
    output_.play(sound_(forces_));
}

} // namespace tactum
