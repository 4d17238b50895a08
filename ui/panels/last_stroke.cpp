#include "ui/panels/last_stroke.h"

#include <utility>

namespace tactum {

namespace {

constexpr double kStep = 2e-5;            // m, between two points that are kept
constexpr double kLifted = 0.1;           // s without touch that end a stroke: a texture throws the finger up
constexpr std::size_t kMaxPoints = 50000; // a metre; of a longer stroke the end is kept

} // namespace

bool LastStroke::add(std::span<const TracePoint> points, double bodiesTime) {
    bool ended = false;
    for (const TracePoint& point : points) {
        // Time goes back where a recording begins.
        if (touching_ && (point.t > touchedAt_ + kLifted || point.t < touchedAt_)) ended = end() || ended;
        if (!point.touching) continue;
        if (!touching_) begin();
        touching_ = true;
        touchedAt_ = point.t;
        const double step = now_.empty() ? kStep : (point.proxy - now_.back().proxy_W).norm();
        if (step < kStep) continue;
        if (!now_.empty()) length_ += step;
        now_.push_back({point.proxy, bodiesTime});
        if (now_.size() > kMaxPoints) now_.erase(now_.begin(), now_.begin() + kMaxPoints / 2);
    }
    return ended;
}

void LastStroke::begin() {
    now_.clear();
    length_ = 0;
}

bool LastStroke::end() {
    touching_ = false;
    if (length_ < kShortest) return false;
    last_ = std::exchange(now_, {});
    return true;
}

} // namespace tactum
