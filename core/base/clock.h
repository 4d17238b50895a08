// Clocks that nobody sets.
#pragma once

#include <cstdint>
#include <ctime>

namespace tactum {

/// Thread of all here: any, real time too, also a signal handler and a forked child.
inline std::int64_t nanosecondsOf(clockid_t clock) noexcept {
    timespec time{};
    clock_gettime(clock, &time);
    return std::int64_t(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
}
/// Stands still only while the machine sleeps; the same in every process.
inline std::int64_t monotonicNanoseconds() noexcept {
    return nanosecondsOf(CLOCK_MONOTONIC);
}
/// The processor time of the calling thread.
inline std::int64_t threadNanoseconds() noexcept {
    return nanosecondsOf(CLOCK_THREAD_CPUTIME_ID);
}
/// Goes on while the machine sleeps.
inline std::int64_t bootNanoseconds() noexcept {
    return nanosecondsOf(CLOCK_BOOTTIME);
}

} // namespace tactum
