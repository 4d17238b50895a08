#include "core/runtime/canary.h"

#include <algorithm>

#include "core/loop/metronome.h"

namespace tactum {
namespace {

constexpr int kPriority = 90; ///< above the guardian and the loops

} // namespace

void Canary::sing(double servoRate) noexcept {
    Metronome metronome(kBeats * servoRate);
    int at = -1;
    std::size_t next = 0;
    while (!stop_.load(std::memory_order_relaxed)) {
        const Tick tick = metronome.wait();
        const std::int64_t woke = monotonicNanoseconds();
        if (tick.late * servoRate > kNoted) {
            Delay& delay = delays_[next++ % delays_.size()];
            delay.from.store(woke - std::int64_t(1e9 * tick.late), std::memory_order_relaxed);
            delay.until.store(woke, std::memory_order_relaxed);
        }
        const int processor = processor_.load(std::memory_order_relaxed);
        if (processor >= 0 && processor != at) stayOn(at = processor);
    }
}

bool Canary::explains(std::int64_t begin, std::int64_t end, std::int64_t late) const noexcept {
    std::int64_t away = 0;
    for (const Delay& delay : delays_) {
        const std::int64_t from = delay.from.load(std::memory_order_relaxed),
                           until = delay.until.load(std::memory_order_relaxed);
        if (until >= begin && from <= end) away += until - from;
    }
    constexpr double kUnseen = 1 / kBeats + kNoted; // periods, of an absence that began right after a beat
    return double(away) >= double(late) - kUnseen * period_;
}

Result<void> Canary::start(double servoRate) {
    stop();
    stop_ = false;
    period_ = 1e9 / servoRate;
    return thread_.start("tactum-canary", kPriority, [this, servoRate] { sing(servoRate); });
}

void Canary::stop() {
    stop_ = true;
    thread_.join();
}

} // namespace tactum
