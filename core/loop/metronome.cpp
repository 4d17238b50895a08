#include "core/loop/metronome.h"

#include <algorithm>
#include <cerrno>
#include <ctime>

namespace tactum {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr double kHalf = 0.5;
constexpr std::int64_t kBurst = 4; ///< times its rate that frames may come
/// No machine sleeps for less, and reading two clocks takes less, unless the thread is stopped between them.
constexpr std::int64_t kShortestSleep = 1'000'000; // ns

void sleepUntil(std::int64_t nanoseconds) noexcept {
    const timespec when{time_t(nanoseconds / kSecond), long(nanoseconds % kSecond)};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &when, nullptr) == EINTR) {
    }
}

} // namespace

Metronome::Metronome(double rate, double rest, Clock sinceBoot) noexcept
    : period_(std::int64_t(double(kSecond) / rate)), start_(monotonicNanoseconds()), last_(start_),
      scheduled_(start_), rest_(rest), sinceBoot_(sinceBoot) {
    asleep();
}

// The clock since boot is read first: whatever comes between the two readings makes the machine's sleep
// shorter, never longer.
std::int64_t Metronome::asleep() noexcept {
    const std::int64_t boot = sinceBoot_();
    const std::int64_t ahead = boot - monotonicNanoseconds();
    const std::int64_t more = ahead - slept_;
    if (more <= 0) return 0;
    slept_ = ahead;
    return more > kShortestSleep ? more : 0;
}

Tick Metronome::wait() noexcept {
    const std::int64_t due = scheduled_ + period_;
    const std::int64_t now = monotonicNanoseconds();
    sleepUntil(std::max(due, now + std::int64_t(rest_ * double(now - last_))));
    return wakeUp(due, now < due, false);
}

Tick Metronome::wait(HapticDevice& device) noexcept {
    const std::int64_t due = scheduled_ + period_, soonest = last_ + period_ / kBurst;
    const std::int64_t now = monotonicNanoseconds();
    if (!device.awaitFrame(due + period_ / 2)) return wait();
    if (monotonicNanoseconds() < soonest) sleepUntil(soonest);
    return wakeUp(due, now < due, true);
}

/// `sleeping`: it was asleep before the tick was due. `framed`: the next one counts from this one.
Tick Metronome::wakeUp(std::int64_t due, bool sleeping, bool framed) noexcept {
    const std::int64_t woke = monotonicNanoseconds(), slept = asleep();
    Tick tick;
    tick.time = double(woke - start_) / double(kSecond);
    tick.elapsed = last_ == start_ ? period() : double(woke - last_ + slept) / double(kSecond);
    const std::int64_t late = std::max(std::int64_t(0), woke + slept - due);
    tick.late = double(late) / double(kSecond);
    tick.missed = late > period_;
    tick.woke = woke;
    tick.asleep = sleeping;
    tick.framed = framed;
    scheduled_ = tick.missed || framed ? woke : due;
    last_ = woke;
    return tick;
}

double Metronome::period() const noexcept {
    return double(period_) / double(kSecond);
}

void HalfSecond::add(double now, double value) noexcept {
    sum_ += value;
    largest_ = std::max(largest_, value);
    ++count_;
    const double length = now - begin_;
    if (length < kHalf) return;
    rate_ = count_ / length;
    mean_ = sum_ / count_;
    worst_ = largest_;
    begin(now);
}

void HalfSecond::begin(double now) noexcept {
    begin_ = now;
    sum_ = largest_ = 0;
    count_ = 0;
}

} // namespace tactum
