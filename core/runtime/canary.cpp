#include "core/runtime/canary.h"

#include <sched.h>

#include "core/runtime/metronome.h"

namespace tactum {
namespace {

constexpr int kPriority = 90;           ///< above the guardian and the loops
constexpr double kRate = 1000;          ///< Hz
constexpr std::int64_t kLate = 200'000; ///< ns; a wake-up takes some tens of microseconds

void moveTo(int processor) noexcept {
    cpu_set_t only;
    CPU_ZERO(&only);
    CPU_SET(std::size_t(processor), &only);
    sched_setaffinity(0, sizeof(only), &only); // of this thread; refused, it stays where it is
}

} // namespace

void Canary::sing() noexcept {
    Metronome metronome(kRate);
    int at = -1;
    while (!stop_.load(std::memory_order_relaxed)) {
        const Tick tick = metronome.wait();
        const std::int64_t woke = monotonicNanoseconds();
        const auto late = std::int64_t(1e9 * (tick.elapsed - metronome.period()));
        if (late > kLate) {
            lateFrom_.store(woke - late, std::memory_order_relaxed);
            lateUntil_.store(woke, std::memory_order_relaxed);
        }
        const int processor = processor_.load(std::memory_order_relaxed);
        if (processor >= 0 && processor != at) moveTo(at = processor);
    }
}

Result<void> Canary::start() {
    stop();
    stop_ = false;
    return thread_.start("tactum-canary", kPriority, [this] { sing(); });
}

void Canary::stop() {
    stop_ = true;
    thread_.join();
}

} // namespace tactum
