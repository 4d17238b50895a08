#include "core/loop/wake_latency.h"

#include <algorithm>
#include <atomic>

#include "core/loop/metronome.h"
#include "core/loop/realtime_thread.h"

namespace tactum {
namespace {

constexpr double kLooks = 10; ///< a second, of whoever waits

} // namespace

void LatencyHistogram::add(double late) noexcept {
    ++ticks_;
    worst_ = std::max(worst_, late);
    ++bins_[std::size_t(std::clamp(late * 1e6, 0.0, double(kBins)))];
}

double LatencyHistogram::quantile(double part) const noexcept {
    const double wanted = part * double(ticks_);
    std::uint64_t sum = 0;
    for (std::size_t bin = 0; bin < kBins; ++bin)
        if (sum += bins_[bin]; double(sum) >= wanted) return std::min(worst_, 1e-6 * double(bin + 1));
    return worst_;
}

std::uint64_t LatencyHistogram::laterThan(double seconds) const noexcept {
    std::uint64_t sum = 0;
    for (std::size_t bin = std::size_t(seconds * 1e6 + 0.5); bin <= kBins; ++bin)
        sum += bins_[bin];
    return sum;
}

Result<LatencyReport> measureLatency(double rate, double seconds, const Progress& progress) {
    const AwakeProcessors awake;
    LatencyReport report{.rate = rate, .urgency = {}, .unlocked = lockPresentMemory(), .late = {}};
    std::atomic<bool> stop{false};
    std::atomic<double> time{0};
    RealtimeThread thread;
    const auto body = [&] {
        Metronome metronome(rate);
        while (!stop && time < seconds) {
            const Tick tick = metronome.wait();
            report.late.add(tick.late);
            time = tick.time;
        }
    };
    if (const auto started = thread.start("tactum-latency", kServoPriority, body); !started)
        return tl::unexpected(started.error());
    for (Metronome looks(kLooks); !thread.joinWithin(0); looks.wait()) {
        if (progress.report) progress.report(std::min(1.0, time / seconds));
        stop = progress.isCancelled();
    }
    report.urgency = thread.urgency();
    return report;
}

} // namespace tactum
