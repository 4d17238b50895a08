#include "core/runtime/metronome.h"

#include <algorithm>
#include <cerrno>
#include <ctime>

namespace tactum {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr double kHalf = 0.5;

void sleepUntil(std::int64_t nanoseconds) noexcept {
    const timespec when{time_t(nanoseconds / kSecond), long(nanoseconds % kSecond)};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &when, nullptr) == EINTR) {
    }
}

} // namespace

std::int64_t monotonicNanoseconds() noexcept {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return std::int64_t(now.tv_sec) * kSecond + now.tv_nsec;
}

Metronome::Metronome(double rate, double rest) noexcept
    : period_(std::int64_t(double(kSecond) / rate)), start_(monotonicNanoseconds()), last_(start_),
      scheduled_(start_), rest_(rest) {}

Tick Metronome::wait() noexcept {
    const std::int64_t due = scheduled_ + period_;
    const std::int64_t now = monotonicNanoseconds();
    sleepUntil(std::max(due, now + std::int64_t(rest_ * double(now - last_))));

    const std::int64_t woke = monotonicNanoseconds();
    Tick tick;
    tick.time = double(woke - start_) / double(kSecond);
    tick.elapsed = last_ == start_ ? period() : double(woke - last_) / double(kSecond);
    tick.missed = woke - due > period_;
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
    begin_ = now;
    sum_ = largest_ = 0;
    count_ = 0;
}

} // namespace tactum
