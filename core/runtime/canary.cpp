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
    std::int64_t last = 0; // ns, of a beat that was late enough
    while (!stop_.load(std::memory_order_relaxed)) {
        const Tick tick = metronome.wait();
        if (tick.late * servoRate > kNoted) {
            Delay& delay = delays_[next++ % delays_.size()];
            const std::int64_t due = tick.woke - std::int64_t(1e9 * tick.late);
            delay.from.store(last > 0 ? last : due, std::memory_order_relaxed);
            delay.until.store(tick.woke, std::memory_order_relaxed);
        }
        last = tick.late * servoRate > kTorn ? tick.woke : 0;
        const int processor = processor_.load(std::memory_order_relaxed);
        if (processor >= 0 && processor != at) stayOn(at = processor);
    }
}

bool Canary::explains(std::int64_t due, std::int64_t woke, bool asleep) const noexcept {
    std::int64_t away = 0;
    for (const Delay& delay : delays_) {
        const std::int64_t from = delay.from.load(std::memory_order_relaxed),
                           until = delay.until.load(std::memory_order_relaxed);
        away += std::max(std::int64_t(0), std::min(until, woke) - std::max(from, due));
    }
    constexpr double kUnseen = 1 / kBeats + kNoted; // periods, of an absence that began right after a beat
    constexpr double kNoise = 1e5;                  // ns: so late is a thread on an ordinary machine anyway
    return double(away) >=
           (asleep ? std::max(kNoise, kTorn * period_) : double(woke - due) - kUnseen * period_);
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
