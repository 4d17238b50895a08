#include "core/loop/metronome.h"

#include <algorithm>
#include <cerrno>
#include <ctime>

namespace tactum {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr double kHalf = 0.5;
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

    const std::int64_t woke = monotonicNanoseconds(), slept = asleep();
    Tick tick;
    tick.time = double(woke - start_) / double(kSecond);
    tick.elapsed = last_ == start_ ? period() : double(woke - last_ + slept) / double(kSecond);
    const std::int64_t late = woke + slept - due;
    tick.late = double(late) / double(kSecond);
    tick.missed = late > period_;
    tick.woke = woke;
    tick.asleep = now < due;
    scheduled_ = tick.missed ? woke : due;
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
