#include "ui/rumble/rumble_link.h"

#include <algorithm>
#include <utility>

namespace tactum {

RumbleLink::RumbleLink(QObject* parent) : QObject(parent) {}

RumbleLink::~RumbleLink() {
    setOn(false);
}

void RumbleLink::setOn(bool on) {
    if (on == this->on()) return;
    pads_.reset();
    found_.clear();
    motors_.rest();
    ++times_;
    if (!on) return;
    pads_ = std::make_unique<Pads>([this, time = times_](std::vector<Pad> found) {
        QMetaObject::invokeMethod(
            this,
            [this, time, found = std::move(found)]() mutable {
                if (time == times_) take(std::move(found));
            },
            Qt::QueuedConnection);
    });
    pads_->use(chosen_);
}

void RumbleLink::take(std::vector<Pad> found) {
    found_ = std::move(found);
    emit padsChanged();
}

void RumbleLink::choose(const std::string& key) {
    chosen_ = key;
    if (pads_) pads_->use(key);
}

std::optional<Pad> RumbleLink::used() const {
    if (found_.empty()) return std::nullopt;
    const auto it = std::ranges::find(found_, chosen_, &Pad::key);
    return it != found_.end() ? *it : found_.front();
}

void RumbleLink::setAttended(bool attended) {
    attended_ = attended;
    if (attended) return;
    motors_.rest();
    if (pads_) pads_->play({});
}

// Without force, for instance after a stop, it is as if nothing were touched; at once, and not after a while.
void RumbleLink::play(const std::vector<TracePoint>& points, double rate) {
    if (!pads_ || !attended_ || points.empty()) return;
    if (std::exchange(rate_, rate) != rate) motors_ = PadMotors(rate);
    for (const TracePoint& point : points)
        if (point.gain > 0)
            motors_.tick(point.force, point.touching);
        else
            motors_.rest();
    pads_->play(motors_.strengths(strength_));
}

} // namespace tactum
