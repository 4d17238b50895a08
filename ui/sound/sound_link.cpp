#include "ui/sound/sound_link.h"

#include <utility>

namespace tactum {

bool SoundLink::start() {
    sound_ = ContactSound(rate_);
    return output_.start();
}

void SoundLink::play(const std::vector<TracePoint>& points, double rate) {
    if (!output_.playing()) return;
    if (std::exchange(rate_, rate) != rate) sound_ = ContactSound(rate);
    forces_.clear();
    for (const TracePoint& point : points)
        forces_.push_back(point.force);
    output_.play(sound_(forces_));
}

} // namespace tactum
